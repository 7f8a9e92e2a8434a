#include "formats/shadertoy/toy.h"

std::string toy_pass_name(ToyPass::Kind kind, int place) {
    switch (kind) {
        case ToyPass::Kind::common:
            return "Common";
        case ToyPass::Kind::buffer:
            return std::string("Buffer ") + static_cast<char>('A' + place);
        case ToyPass::Kind::cube:
            return "Cube A";
        case ToyPass::Kind::image:
            return "Image";
        case ToyPass::Kind::sound:
            break;
    }
    return "Sound";
}
