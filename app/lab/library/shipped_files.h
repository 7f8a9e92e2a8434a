#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

/// The presets and looks that the program is shipped with: the digest of each file, by its path
/// below the root that holds `shaders/` and `presets/`.
using ShippedFiles = std::map<std::string, std::uint64_t>;

/// As listed when the program was built.
ShippedFiles files_of_build();

/// Whether `file` lies below `root` as it was shipped. A file that was changed since is the user's.
bool is_shipped(const ShippedFiles& shipped, const std::filesystem::path& root,
                const std::filesystem::path& file);
