#pragma once

#include "model/look/picture.h"
#include "signals/patterns/patterns.h"

/// A pattern and its draw function.
struct Pattern {
    PatternInfo info;
    Extent initial;  // default size
    /// `seconds` since the start; only moving patterns read it. Deterministic.
    Picture (*draw)(Extent extent, double seconds);
};
