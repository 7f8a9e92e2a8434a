#pragma once

#include "base/diagnostic.h"
#include "model/preset/preset.h"

#include <filesystem>
#include <string>
#include <string_view>

/// The PNG with the preset in an iTXt chunk under "afterglow-preset", in place of one that it held.
/// Errors carry no file.
Result<std::string> with_preset(std::string_view png, const Preset& preset,
                                const Look* look = nullptr);

/// The preset that a PNG holds. Errors name `file`.
Result<Preset> preset_from_png(std::string_view png, const std::filesystem::path& file);
