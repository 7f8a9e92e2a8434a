#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <filesystem>
#include <string_view>
#include <vector>

class ShaderFiles;

/// `driven_by` of a look that a signal or a source picture can drive.
constexpr std::string_view either_driver = "signal-or-picture";

/// The id of a look: the name of its folder.
std::string look_id_of(const std::filesystem::path& manifest);

/// Loads look.json: everything except the shader texts (its stages name their files) and the
/// parameters. Named files must be in the look's folder; they become full paths, also in
/// default_source and default_signal. `files` receives the manifest and all files that it names.
/// Reports all errors at once, with the manifest's lines. `disk` may be null. If a signal or a
/// picture can drive the look, it is read for a picture with `is_picture_driven`, otherwise for a
/// signal.
Result<Look> load_manifest(const std::filesystem::path& manifest,
                           std::vector<std::filesystem::path>& files, ShaderFiles* disk = nullptr,
                           bool is_picture_driven = false);
