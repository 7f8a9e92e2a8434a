#pragma once

#include "formats/look/loaded_look.h"

/// Whether a file is a single fragment shader: a text with main() and without the marks of another
/// format. A missing file is judged by its name.
bool is_fragment_file(const std::filesystem::path& file);

/// Loads one as a look with one pass: GLSL ES 1.00 and 3.00 and desktop versions, with the uniforms
/// of GameMaker, glslViewer, three.js, raylib and Shadertoy. Other uniforms become parameters, as
/// in native looks. Errors from includes and glslang have their lines.
LoadedLook load_fragment_look(const std::filesystem::path& file, const IncludeFolders& includes,
                              const LoadOptions& help);
