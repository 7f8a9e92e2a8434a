#pragma once

#include <cstdint>

/// A dot-matrix font: 5 dots wide, 7 high, and an eighth row for descenders.
namespace bitmap_font {

constexpr int width = 5;
constexpr int height = 8;

/// Whether a dot of a printable ASCII character is set; x from the left, y from the top. False for
/// other characters.
bool has_dot(char character, int x, int y);

}  // namespace bitmap_font
