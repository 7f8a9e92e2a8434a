#pragma once

#include "model/look/extent.h"

#include <array>
#include <optional>

/// The position and size of the window, and of its text.
struct WindowGeometry {
    Extent size{1440, 900};  // screen coordinates
    std::optional<std::array<int, 2>> position;
    bool is_maximised = false;
    double scale = 1.0;  // of text and controls, on top of the display's own
};
