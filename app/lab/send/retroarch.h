#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <string>

/// Tells a running RetroArch to load a shader preset, by its network commands VERSION and
/// SET_SHADER. `port`: of this machine, as a number. Only VERSION is answered.
Result<void> load_in_retroarch(const std::filesystem::path& preset, const std::string& port);
