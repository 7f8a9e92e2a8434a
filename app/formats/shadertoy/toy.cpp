#include "formats/shadertoy/toy.h"

std::string_view words_for(ToyKind kind) {
    switch (kind) {
        case ToyKind::nothing:
            break;
        case ToyKind::buffer:
            return "a buffer";
        case ToyKind::texture:
            return "a texture";
        case ToyKind::cubemap:
            return "a cubemap";
        case ToyKind::volume:
            return "a volume";
        case ToyKind::keyboard:
            return "the keyboard";
        case ToyKind::video:
            return "a video";
        case ToyKind::webcam:
            return "the webcam";
        case ToyKind::music:
            return "music";
        case ToyKind::music_stream:
            return "streamed music";
        case ToyKind::microphone:
            return "the microphone";
    }
    return "nothing";
}

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
