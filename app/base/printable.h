#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Text for a terminal. Control characters (C0, DEL, C1 of Unicode 15, line ends too) and bytes
/// that are not valid UTF-8 become "\x1b".
std::string printable(std::string_view text);

/// At most `max_bytes` bytes of a text, cut between characters; "…" is appended if text was cut.
std::string shortened(std::string text, std::size_t max_bytes);
