#pragma once

#include <filesystem>
#include <map>
#include <string>

/// The text of a preset that refers to `referred`, or draws the shader that it is, and sets
/// `values`: sorted by name, each in its shortest form. `saved_as` is where it will stand; the
/// reference is relative to its folder where both are on one disk, with '/' between its parts.
std::string simple_slang_preset(const std::filesystem::path& referred,
                                const std::map<std::string, double>& values,
                                const std::filesystem::path& saved_as);
