#pragma once

#include "model/look/look.h"

#include <optional>
#include <string>
#include <vector>

/// What a channel of a pass reads.
enum class ToyKind {
    nothing,
    buffer,
    texture,
    cubemap,
    volume,
    keyboard,
    video,
    webcam,
    music,
    music_stream,
    microphone
};

constexpr int toy_channels = 4;

/// A channel of a pass as it is wired.
struct ToyInput {
    int channel = 0;
    ToyKind kind = ToyKind::nothing;
    int buffer = -1;    // of a buffer: its place, as ToyPass::place; below 0: there is none such
    std::string asset;  // path of what is read, as it is written
    Sampler sampler;
    bool is_flipped = true;  // its bottom row is read at v = 0
    bool is_file = false;    // `asset` leads on from the shader's own folder
    Location declared;
};

/// A pass of a shader that was written for Shadertoy.
struct ToyPass {
    enum class Kind { common, buffer, cube, image, sound };

    Kind kind = Kind::image;
    int place = 0;     // 0..3: Buffer A..D; toy_cube_place; the order in which they are drawn
    std::string name;  // "Buffer A"
    Stage code;        // as its author wrote it
    std::vector<ToyInput> inputs;
    // Where nothing says what channels read, those that are not wired read buffers, else pictures.
    bool is_wired = true;
};

constexpr int toy_cube_place = 4;

/// "Buffer A", "Cube A", "Image": what the site calls a pass.
std::string toy_pass_name(ToyPass::Kind kind, int place);

/// A whole shader of Shadertoy, wherever it was read from.
struct Toy {
    std::string name;
    std::string author;
    std::string about;
    std::vector<ToyPass> passes;
};
