#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <filesystem>
#include <vector>

class ShaderFiles;

/// A look's id: its folder's own name.
std::string look_id_of(const std::filesystem::path& manifest);

/// Reads look.json: everything of a look but the texts of its shaders (its stages name their files)
/// and its parameters. Files that it names are checked to lie in its folder and become full paths,
/// also in default_source and default_signal. `files` gets the manifest and all that it names.
/// Errors have the manifest's lines; all that can be told at once are. `disk` may be null.
Result<Look> load_manifest(const std::filesystem::path& manifest,
                           std::vector<std::filesystem::path>& files, ShaderFiles* disk = nullptr);
