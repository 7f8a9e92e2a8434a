#pragma once

#include "base/diagnostic.h"
#include "model/devices/remote_settings.h"

#include <filesystem>
#include <string>
#include <string_view>

std::string remote_settings_to_json(const RemoteSettings& settings);
/// Unknown keys and numbers that are no port are errors with their line.
Result<RemoteSettings> parse_remote_settings(std::string_view text,
                                             const std::filesystem::path& file);
