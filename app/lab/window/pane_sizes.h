#pragma once

#include "model/look/parameter.h"

#include <array>

/// Widths and heights of the panes in pixels at scale 1.
struct PaneSizes {
    float left = 252.0f;
    float right = 344.0f;
    float strip = 132.0f;
    float bottom = 150.0f;
    float inspector = 330.0f;

    bool operator==(const PaneSizes&) const = default;
};

/// A resizable pane with its limits.
struct PaneSide {
    const char* larger;   // "Widen left pane"
    const char* smaller;  // "Narrow left pane"
    float PaneSizes::*size;
    Limit limit;  // px at scale 1
};
const std::array<PaneSide, 5>& pane_sides();

/// Changes the size within its limit.
void resize_pane(PaneSizes& panes, float PaneSizes::*size, float by);
