#pragma once

#include "signals/drawing/scene.h"

#include <string>
#include <string_view>
#include <vector>

enum class TextAlign { left, middle, right };

/// A text in Afterglow's stroke font, centred at 0,0. `height` is the height of a capital in half
/// screens. Small letters are small capitals. Covers ASCII, Latin-1 and Latin Extended-A. A missing
/// character is drawn as a box; "\n" ends a line.
std::vector<ScenePath> text_paths(std::string_view text, double height, TextAlign align);

/// The characters that the font lacks, each once, separated by spaces; "": none.
std::string missing_letters(std::string_view text);
