#pragma once

#include "formats/shadertoy/shadertoy.h"

#include <filesystem>
#include <functional>

/// Reads the directives of the Visual Studio Code extension Shader Toy in a pass from a file.
/// `#iChannel0 "file://a.png"`, with `::MinFilter`, `::MagFilter`, `::WrapMode` or `::Type` after
/// the name, becomes an input. `#iUniform float gain = 0.5 in { 0.0, 1.0 }` becomes a uniform with
/// its range. Line numbers are unchanged. `buffer_of` returns the index of the buffer (or of the
/// pass itself) for a shader file. `warnings` receives unsupported directives.
void read_shadertoy_directives(
    ShadertoyPass& pass, const std::function<int(const std::filesystem::path& file)>& buffer_of,
    Diagnostics& warnings);
