#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <string>

/// The position of a line of text in a picture, in pixels from the top left.
struct CaptionPosition {
    int left = 0;
    int baseline = 0;
    int width = 0;   // longer text is cut and ends in "…"
    int height = 0;  // of the font
};

/// Draws a line of light grey text into a picture. Fails if the system has none of the fonts that
/// we use.
Result<void> draw_caption(Picture& picture, const CaptionPosition& position,
                          const std::string& text);
