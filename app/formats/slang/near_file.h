#pragma once

#include <filesystem>
#include <string>

/// For a file that is missing: " (did you mean 'shaders/stock.slang'?)" where one stands at its
/// place in other letters, or one of its name beside `from`, the file that names it; else "". The
/// path is from the folder of `from` on.
std::string near_file(const std::filesystem::path& wanted, const std::filesystem::path& from);
