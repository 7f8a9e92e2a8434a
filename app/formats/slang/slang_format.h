#pragma once

#include "formats/look/loaded_look.h"

/// Reads a chain of libretro's shaders as a look: a .slangp preset with all that it refers to, or
/// one .slang shader. Errors are the files' and glslang's, each at its line; a
/// shader of several passes tells its own once.
LoadedLook load_slang_look(const std::filesystem::path& file, const ReadingHelp& help);

/// Whether a file is one of these, by its name.
bool is_slang_file(const std::filesystem::path& file);
