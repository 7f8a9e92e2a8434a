#pragma once

#include "model/photo/light_curve.h"

#include <string>

/// One exponential of a decay.
struct TimeConstant {
    double seconds = 0.0;
    double low = 0.0;  // 90 % interval
    double high = 0.0;
    double share = 0.0;   // of the light after the light went off
    std::string why_not;  // why it is not identifiable; "": it is
};

/// Fits one to three exponentials to a recorded decay, and returns the slowest last. The Bayesian
/// information criterion chooses their number (Schwarz 1978). Their amounts are positive, and the
/// background is constant. Least squares with variable projection on a grid (Golub and Pereyra
/// 1973), then Gauss-Newton. A constant shorter than a frame or with an interval wider than half
/// its value is not identifiable.
std::vector<TimeConstant> time_constants(const RecordedDecay& recorded);
