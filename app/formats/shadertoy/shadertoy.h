#pragma once

#include "model/look/look.h"

#include <optional>
#include <string>
#include <vector>

/// The source of a pass's channel.
enum class ShadertoyKind {
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

constexpr int shadertoy_channels = 4;

/// The connection of a channel of a pass.
struct ShadertoyInput {
    int channel = 0;
    ShadertoyKind kind = ShadertoyKind::nothing;
    int buffer = -1;    // for a buffer: see ShadertoyPass::index; below 0: does not exist
    std::string asset;  // path of the source, as written
    Sampler sampler;
    bool is_flipped = true;  // v = 0 is the bottom row
    bool is_file = false;    // `asset` is relative to the shader's folder
    Location declared;
};

/// A pass of a Shadertoy shader.
struct ShadertoyPass {
    enum class Kind { common, buffer, cube, image, sound };

    Kind kind = Kind::image;
    int index = 0;     // 0..3: Buffer A..D; shadertoy_cube_index; defines the drawing order
    std::string name;  // "Buffer A"
    Stage code;        // as written by the author
    std::vector<ShadertoyInput> inputs;
    // If false, unconnected channels read the buffer with their number or a picture.
    bool has_explicit_inputs = true;
};

constexpr int shadertoy_cube_index = 4;

/// The site's name for a pass: "Buffer A", "Cube A", "Image".
std::string shadertoy_pass_name(ShadertoyPass::Kind kind, int index);

/// A complete Shadertoy shader, from any source format.
struct Shadertoy {
    std::string name;
    std::string author;
    std::string about;
    std::vector<ShadertoyPass> passes;
};
