#pragma once

#include "formats/look/loaded_look.h"

/// Whether a file is a shader of Shadertoy: JSON, told by what it holds (one that is not there by
/// its name), or a text with mainImage().
bool is_toy_file(const std::filesystem::path& file);

/// Reads one as a look. Errors are JSON's, the include's and glslang's, each at its line; in JSON
/// the file is "FILE/PASS" and the line the author's.
LoadedLook load_toy_look(const std::filesystem::path& file, const IncludeFolders& includes,
                         const ReadingHelp& help);
