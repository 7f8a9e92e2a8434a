#pragma once

#include "model/look/look.h"

/// A texture of a look: a pass's output of n frames ago, the source, an image, or a mip level of
/// these.
struct TextureChoice {
    Input::From from = Input::From::pass;
    std::string name;  // of the pass or image
    int frames_ago = 0;
    int level = 0;            // 0: the largest
    SoundTexture sound = {};  // sound only

    bool operator==(const TextureChoice&) const = default;
    bool is_present_pass() const {
        return from == Input::From::pass && frames_ago == 0 && level == 0;
    }
    /// The same texture of this frame, at its largest level.
    TextureChoice current() const { return {from, name, 0, 0, sound}; }
    /// "persistence@1", "source", "noise mip 2".
    std::string label() const;
};
