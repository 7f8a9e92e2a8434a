#pragma once

#include "lab/window/window_state.h"
#include "model/look/parameter.h"

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
