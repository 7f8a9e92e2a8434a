#pragma once

#include "formats/look/loaded_look.h"

/// Whether a file is a Shadertoy shader: JSON, recognised by its content (a missing file by its
/// name), or a text with mainImage().
bool is_shadertoy_file(const std::filesystem::path& file);

/// Loads one as a look. Errors of JSON, includes and glslang have their lines. For JSON, the file
/// of an error is "FILE/PASS" and the line is the author's.
LoadedLook load_shadertoy_look(const std::filesystem::path& file, const IncludeFolders& includes,
                               const LoadOptions& help);
