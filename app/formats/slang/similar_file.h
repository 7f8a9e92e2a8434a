#pragma once

#include <filesystem>
#include <string>

/// " (did you mean 'shaders/stock.slang'?)" for a missing file, otherwise "". Suggests a file whose
/// path differs only in case, or one with its name next to `from`, the referencing file. The path
/// is relative to the folder of `from`.
std::string similar_file(const std::filesystem::path& wanted, const std::filesystem::path& from);
