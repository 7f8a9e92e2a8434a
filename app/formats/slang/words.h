#pragma once

#include <optional>
#include <string>
#include <string_view>

/// The number that a text begins with, as C reads it: "1", ".5", "-1e-3", "1.0;" is 1. Nothing
/// when it begins with none, and for what no 32-bit float holds.
std::optional<double> leading_number(std::string_view text);

/// What to say of a text, the value of `key`, whose number goes on behind a comma, "0,5"; "" where
/// it does not.
std::string decimal_comma_note(std::string_view key, std::string_view text);

/// Why a text that stands in a file is no path; "" where it may be one.
std::string fault_of_slang_path(std::string_view written);

/// The text in UTF-8: as it is where it is valid, else its odd bytes read as Latin-1.
std::string readable_text(std::string_view bytes);
