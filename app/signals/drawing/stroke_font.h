#pragma once

#include "signals/drawing/scene.h"

#include <string>
#include <string_view>
#include <vector>

enum class TextAlign { left, middle, right };

/// A text in Afterglow's own stroke font, around 0,0. `height` is a capital's, half screens. Small
/// letters are small capitals; the letters are those of ASCII, Latin-1 and Latin Extended-A. A
/// character that the font lacks is a box; "\n" ends a line.
std::vector<ScenePath> text_paths(std::string_view text, double height, TextAlign align);

/// The characters of a text that the font lacks, each once, with blanks between; "": none.
std::string missing_letters(std::string_view text);
