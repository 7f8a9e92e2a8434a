#pragma once

#include "base/diagnostic.h"
#include "base/work.h"

#include <filesystem>
#include <string>

/// The CRC-32 of a regular file's bytes as eight hexadecimal digits: tells whether a sound or
/// picture is the one that a preset was judged on, and is no protection against a forger.
Result<std::string> file_digest(const std::filesystem::path& file, Work* work = nullptr);
