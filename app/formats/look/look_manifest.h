#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <filesystem>
#include <vector>

class ShaderFiles;

/// The id of a look: the name of its folder.
std::string look_id_of(const std::filesystem::path& manifest);

/// Loads look.json: everything except the shader texts (its stages name their files) and the
/// parameters. Named files must be in the look's folder; they become full paths, also in
/// default_source and default_signal. `files` receives the manifest and all files that it names.
/// Reports all errors at once, with the manifest's lines. `disk` may be null.
Result<Look> load_manifest(const std::filesystem::path& manifest,
                           std::vector<std::filesystem::path>& files, ShaderFiles* disk = nullptr);
