#pragma once

#include "base/diagnostic.h"
#include "model/devices/sound_settings.h"

#include <filesystem>
#include <string>
#include <string_view>

/// The user's audio devices as a file.
std::string sound_settings_to_json(const SoundSettings& settings);
Result<SoundSettings> parse_sound_settings(std::string_view text,
                                           const std::filesystem::path& file);
