#pragma once

#include "lab/window/window_state.h"
#include "model/look/parameter.h"

/// A pane that a person may make larger, and within what.
struct PaneSide {
    const char* larger;   // "Widen left pane"
    const char* smaller;  // "Narrow left pane"
    float PaneSizes::*size;
    Limit limit;  // px at a scale of 1
};
const std::array<PaneSide, 5>& pane_sides();

/// Within its limit.
void resize_pane(PaneSizes& panes, float PaneSizes::*size, float by);
