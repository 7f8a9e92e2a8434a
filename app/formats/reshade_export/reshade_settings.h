#pragma once

#include "formats/reshade_export/fx_controls.h"

#include <filesystem>
#include <string>
#include <vector>

/// What the settings of an effect refer to.
struct ReshadeNames {
    std::string file;              // "crt.fx"
    std::string technique;         // "Afterglow_crt"
    std::filesystem::path folder;  // of the file, absolute, without quotes
};

/// A preset of ReShade, which turns on the effect and has all present values.
std::string reshade_preset(const ReshadeNames& names, const std::vector<FxControl>& controls);

/// The settings of vkBasalt, which turn on the effect and have the present values of all numbers. A
/// vector keeps the default in the effect.
std::string vkbasalt_settings(const ReshadeNames& names, const std::vector<FxControl>& controls);
