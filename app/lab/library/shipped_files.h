#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

/// The digests of the shipped presets and looks, by path relative to the root with `shaders/` and
/// `presets/`.
using ShippedFiles = std::map<std::string, std::uint64_t>;

/// The list from the build.
ShippedFiles files_of_build();

/// Whether `file` below `root` is unchanged since it was shipped. A changed file is the user's.
bool is_shipped(const ShippedFiles& shipped, const std::filesystem::path& root,
                const std::filesystem::path& file);
