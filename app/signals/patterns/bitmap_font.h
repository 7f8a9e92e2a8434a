#pragma once

#include <cstdint>

/// A dot-matrix font, 5 dots wide and 7 high with an eighth row for what hangs below the line.
namespace bitmap_font {

constexpr int width = 5;
constexpr int height = 8;

/// Whether a dot of a printable ASCII character is set, x from the left and y from the top; others
/// have none.
bool has_dot(char character, int x, int y);

}  // namespace bitmap_font
