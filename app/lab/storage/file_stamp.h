#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Changes when the file does, by its size and time; of a numbered sequence when its folder does.
/// "" when it cannot be read.
std::string stamp_of(const std::filesystem::path& file);
/// Of all of them, a line each with its name.
std::string stamp_of(const std::vector<std::filesystem::path>& files);
