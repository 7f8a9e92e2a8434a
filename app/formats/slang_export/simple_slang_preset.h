#pragma once

#include <filesystem>
#include <map>
#include <string>

/// The text of a preset that refers to `referred`, or draws it if it is a shader, and sets
/// `values`. Values are sorted by name, each in its shortest form. `saved_as` is the file's future
/// path. The reference is relative to its folder if both are on one disk, with '/' separators.
std::string simple_slang_preset(const std::filesystem::path& referred,
                                const std::map<std::string, double>& values,
                                const std::filesystem::path& saved_as);
