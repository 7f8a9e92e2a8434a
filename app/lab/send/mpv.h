#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <string>

/// Adds a user shader to a running mpv by its JSON socket. Other shaders of the same folder, from
/// before, leave its list; the user's own stay. mpv reads a path only once, so each shader needs a
/// new name.
Result<void> load_in_mpv(const std::filesystem::path& shader, const std::string& socket);
