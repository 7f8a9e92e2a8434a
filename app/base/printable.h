#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// A text for a terminal: control characters (C0, DEL, C1 as Unicode 15 has them, line ends too)
/// and bytes that are no UTF-8 become "\x1b".
std::string printable(std::string_view text);

/// At most so many bytes of a text, cut between characters, with a "…" where some are missing.
std::string shortened(std::string text, std::size_t most_bytes);
