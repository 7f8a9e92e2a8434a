#pragma once

#include "signals/scene.h"

#include <string_view>
#include <vector>

enum class TextAlign { left, middle, right };

/// A text in Afterglow's own stroke font, around 0,0. `height` is a capital's, half screens. Small
/// letters are small capitals; a character that the font lacks is a box; "\n" ends a line.
std::vector<ScenePath> text_paths(std::string_view text, double height, TextAlign align);
