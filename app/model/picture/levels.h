#pragma once

#include "model/picture/statistics.h"

/// Which numbers a view shows as black and as white; what lies between is spread evenly.
struct Levels {
    double black = 0.0;
    double white = 1.0;  // above black

    bool operator==(const Levels&) const = default;
};

/// With another end; where that would cross the other one, it is pushed along at its distance.
Levels with_black(const Levels& levels, double black);
Levels with_white(const Levels& levels, double white);

/// From the least to the greatest finite number. No share of them is cut off: in the picture of a
/// scope the beam is that share. One number alone is seen against zero.
Levels fitted_levels(const Statistics& statistics);
