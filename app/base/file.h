#pragma once

#include "base/diagnostic.h"

#include <cstddef>
#include <filesystem>
#include <string>

/// The bytes of a regular file of at most `most_bytes`; says why it cannot be had.
Result<std::string> read_bytes(const std::filesystem::path& file,
                               std::size_t most_bytes = std::size_t{1} << 30);

/// The first `count` bytes of a regular file of any size, or all of a shorter one.
Result<std::string> read_start(const std::filesystem::path& file, std::size_t count);

/// As read_bytes, for a text that a person writes (GLSL, JSON): at most 16 MiB, UTF-8 or ASCII
/// without NUL bytes; a byte order mark is dropped.
Result<std::string> read_text(const std::filesystem::path& file);

/// Whether `path` lies in `folder` after links and `..` are followed; false for what does not
/// exist.
bool is_inside(const std::filesystem::path& path, const std::filesystem::path& folder);
