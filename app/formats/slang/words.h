#pragma once

#include <optional>
#include <string>
#include <string_view>

/// The number that a text begins with, as C reads it: "1", ".5", "-1e-3", "1.0;" is 1. Nothing
/// when it begins with none, and for what is not finite.
std::optional<double> leading_number(std::string_view text);

/// The text in UTF-8: as it is where it is valid, else its odd bytes read as Latin-1.
std::string readable_text(std::string_view bytes);
