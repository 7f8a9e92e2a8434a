#pragma once

#include "formats/look/loaded_look.h"

/// Loads a shader of the Interactive Shader Format as a look: a .fs file, and the .vs or .vert file
/// with the same name. Errors of the header and of glslang have their file and line.
LoadedLook load_isf_look(const std::filesystem::path& file, const LoadOptions& help);

/// Whether a file is an ISF shader: a .fs file with an ISF header.
bool is_isf_file(const std::filesystem::path& file);
