#pragma once

#include "base/diagnostic.h"
#include "model/preset/preset.h"

#include <filesystem>
#include <string>
#include <string_view>

/// The PNG with the preset in an iTXt chunk "afterglow-preset", replacing an existing one. Errors
/// have no file.
Result<std::string> with_preset(std::string_view png, const Preset& preset,
                                const Look* look = nullptr);

/// The preset in a PNG. Errors name `file`.
Result<Preset> preset_from_png(std::string_view png, const std::filesystem::path& file);
