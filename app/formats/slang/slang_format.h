#pragma once

#include "formats/look/loaded_look.h"

/// Loads a chain of libretro shaders as a look: a .slangp preset with all its references, or one
/// .slang shader. Errors of the files and of glslang have their lines. Errors of a shader in
/// several passes are reported once.
LoadedLook load_slang_look(const std::filesystem::path& file, const LoadOptions& help);

/// Whether a file is one of these, by its name.
bool is_slang_file(const std::filesystem::path& file);
