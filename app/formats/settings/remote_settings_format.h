#pragma once

#include "base/diagnostic.h"
#include "model/devices/remote_settings.h"

#include <filesystem>
#include <string>
#include <string_view>

std::string remote_settings_to_json(const RemoteSettings& settings);
/// Errors, with lines: unknown keys and invalid ports.
Result<RemoteSettings> parse_remote_settings(std::string_view text,
                                             const std::filesystem::path& file);
