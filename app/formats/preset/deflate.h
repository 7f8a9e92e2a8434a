#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Compresses bytes to a zlib stream (RFC 1950) at the highest level.
std::string deflate_bytes(std::string_view bytes);

/// Decompresses a zlib stream. nullopt if it is damaged, truncated, or larger than `max_bytes` (a
/// few bytes can expand to gigabytes).
std::optional<std::string> inflate_bytes(std::string_view stream, std::size_t max_bytes);
