#pragma once

#include "model/picture/statistics.h"

/// The values that a view shows as black and white; the mapping between them is linear.
struct Levels {
    double black = 0.0;
    double white = 1.0;  // above black

    bool operator==(const Levels&) const = default;
};

/// Changes one end. If it would cross the other end, that end moves along at the same distance.
Levels with_black(const Levels& levels, double black);
Levels with_white(const Levels& levels, double white);

/// From the smallest to the largest finite number, without cutting off a fraction: in a picture of
/// a scope, the beam is that fraction. A uniform picture is shown relative to zero.
Levels fitted_levels(const Statistics& statistics);
