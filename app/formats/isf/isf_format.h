#pragma once

#include "formats/look/loaded_look.h"

/// Reads a shader of the Interactive Shader Format as a look: a .fs file, and the .vs or .vert file
/// of the same name beside it. Errors are the header's and glslang's, each at its file and line.
LoadedLook load_isf_look(const std::filesystem::path& file, const ReadingHelp& help);

/// Whether a file is one: a .fs file that begins with ISF's header.
bool is_isf_file(const std::filesystem::path& file);
