#pragma once

#include "formats/shadertoy/toy.h"

#include <filesystem>

/// Whether a text is a pass of Shadertoy: it defines mainImage() and no main() of its own.
bool is_toy_text(std::string_view text);

/// The Image file of a shader that lies in a folder as one file a pass: "Image.glsl" and, beside
/// it, "Common", "Buffer A" to "Buffer D", "Cube A", "Sound", in the usual ways to write these
/// names.
std::optional<std::filesystem::path> find_toy_image(const std::filesystem::path& folder);

/// Whether a file is a pass of a shader whose Image lies beside it as a file of its own.
bool is_shown_by_another(const std::filesystem::path& file);

/// Reads `file` with the other passes beside it whose names begin as its own does. Includes are
/// found as in a look of our own. `files` gets all that was read or looked for, `warnings` what
/// toy_directives.h cannot have.
Result<Toy> load_toy_files(const std::filesystem::path& file, const IncludeFolders& includes,
                           std::vector<std::filesystem::path>& files, Diagnostics& warnings);
