#pragma once

#include <optional>
#include <string>
#include <string_view>

/// The number at the start of a text, as in C: "1", ".5", "-1e-3"; "1.0;" is 1. nullopt without a
/// number, or if it does not fit a 32-bit float.
std::optional<double> leading_number(std::string_view text);

/// A note about the value of `key` if its number has a decimal comma, "0,5"; otherwise "".
std::string decimal_comma_note(std::string_view key, std::string_view text);

/// Why a text is not a valid path; "" if it may be one.
std::string fault_of_slang_path(std::string_view written);

/// The text as UTF-8; invalid bytes are read as Latin-1.
std::string readable_text(std::string_view bytes);
