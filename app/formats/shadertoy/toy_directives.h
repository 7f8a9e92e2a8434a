#pragma once

#include "formats/shadertoy/toy.h"

#include <filesystem>
#include <functional>

/// Reads the lines that Visual Studio Code's extension Shader Toy has for GLSL, in a pass that lies
/// in a file: `#iChannel0 "file://a.png"`, with `::MinFilter`, `::MagFilter`, `::WrapMode` and
/// `::Type` behind the name, and `#iUniform float gain = 0.5 in { 0.0, 1.0 }`. Channels become
/// inputs, uniforms are declared with their range, and the lines stay the author's.
/// `place_of` gives the place of a buffer, or of the pass itself, for a file that is shader code;
/// `warnings` gets what cannot be had here.
void read_toy_directives(ToyPass& pass,
                         const std::function<int(const std::filesystem::path& file)>& place_of,
                         Diagnostics& warnings);
