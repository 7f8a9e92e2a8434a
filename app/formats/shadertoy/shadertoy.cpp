#include "formats/shadertoy/shadertoy.h"

std::string shadertoy_pass_name(ShadertoyPass::Kind kind, int index) {
    switch (kind) {
        case ShadertoyPass::Kind::common:
            return "Common";
        case ShadertoyPass::Kind::buffer:
            return std::string("Buffer ") + static_cast<char>('A' + index);
        case ShadertoyPass::Kind::cube:
            return "Cube A";
        case ShadertoyPass::Kind::image:
            return "Image";
        case ShadertoyPass::Kind::sound:
            break;
    }
    return "Sound";
}
