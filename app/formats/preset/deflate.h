#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// The zlib stream (RFC 1950) of bytes, at its densest.
std::string deflated(std::string_view bytes);

/// What a zlib stream holds; nothing where it is damaged, cut short, or holds more than
/// `most_bytes` (a few bytes can hold gigabytes).
std::optional<std::string> inflated(std::string_view stream, std::size_t most_bytes);
