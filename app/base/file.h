#pragma once

#include "base/diagnostic.h"

#include <cstddef>
#include <filesystem>
#include <string>

/// The bytes of a regular file of at most `max_bytes`.
Result<std::string> read_bytes(const std::filesystem::path& file,
                               std::size_t max_bytes = std::size_t{1} << 30);

/// The first `count` bytes of a regular file of any size; all bytes of a shorter file.
Result<std::string> read_start(const std::filesystem::path& file, std::size_t count);

/// As read_bytes, for text files (GLSL, JSON): at most 16 MiB, UTF-8 or ASCII without NUL bytes. A
/// byte order mark is removed.
Result<std::string> read_text(const std::filesystem::path& file);

/// Whether `path` is in `folder` after resolving links and `..`; false if either does not exist.
bool is_inside(const std::filesystem::path& path, const std::filesystem::path& folder);
