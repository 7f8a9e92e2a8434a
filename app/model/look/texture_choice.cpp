#include "model/look/texture_choice.h"

std::string TextureChoice::label() const {
    const std::string reference = Input{{}, from, name, frames_ago, {}, sound}.reference();
    return level == 0 ? reference : reference + " mip " + std::to_string(level);
}
