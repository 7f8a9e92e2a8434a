#pragma once

#include "formats/shadertoy/shadertoy.h"

#include <filesystem>

/// Whether a text is a Shadertoy pass: it defines mainImage() and not main().
bool is_shadertoy_text(std::string_view text);

/// The Image file of a shader in a folder with one file per pass: "Image.glsl", with "Common",
/// "Buffer A" to "Buffer D", "Cube A" and "Sound". Accepts the common spellings of these names.
std::optional<std::filesystem::path> find_shadertoy_image(const std::filesystem::path& folder);

/// Whether a file is a pass of a shader whose Image is another file in the same folder.
bool is_shown_by_another(const std::filesystem::path& file);

/// Loads `file` and the other passes in its folder whose names start like its own. Includes are
/// found as in native looks. `files` receives all files read or searched, `warnings` the
/// unsupported directives (shadertoy_directives.h).
Result<Shadertoy> load_shadertoy_files(const std::filesystem::path& file,
                                       const IncludeFolders& includes,
                                       std::vector<std::filesystem::path>& files,
                                       Diagnostics& warnings);
