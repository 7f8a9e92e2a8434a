#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <string>

/// Where one line of text stands in a picture, in pixels from the top left.
struct CaptionPlace {
    int left = 0;
    int baseline = 0;
    int width = 0;   // what does not fit ends in "…"
    int height = 0;  // of the letters
};

/// Writes a line of light grey text into a picture. Fails where the system has no font that we
/// know.
Result<void> draw_caption(Picture& picture, const CaptionPlace& place, const std::string& text);
