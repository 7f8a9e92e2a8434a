#pragma once

#include "model/look/picture.h"
#include "signals/patterns/patterns.h"

/// A pattern and how it is made.
struct Pattern {
    PatternFacts facts;
    Extent initial;  // its size where none is asked for
    /// `seconds` from the start; only patterns that move read it. The same call gives the same
    /// bytes.
    Picture (*draw)(Extent extent, double seconds);
};
