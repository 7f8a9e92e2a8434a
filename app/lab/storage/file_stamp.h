#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Size and modification time of a file, to detect changes. For a numbered sequence, only the time
/// of its folder. "": not readable.
std::string stamp_text(const std::filesystem::path& file);
/// The stamps of all files, one line each with the name.
std::string stamp_text(const std::vector<std::filesystem::path>& files);
