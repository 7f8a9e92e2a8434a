#pragma once

#include "base/diagnostic.h"
#include "model/picture.h"

/// How far two pictures are apart, in the units of their values; alpha does not count.
struct Difference {
    double mean = 0.0;          // of the absolute differences of all components
    double rms = 0.0;           // root of the mean square
    double largest = 0.0;       // NaN against a number counts as infinite
    int largest_x = 0;          // px from the left
    int largest_y = 0;          // px from the top
    double psnr_db = 0.0;       // for a peak of 1; infinite when equal
    double share_beyond = 0.0;  // of the pixels with a component farther apart than the tolerance
};

/// Fails when sizes or channels differ. A grey picture compares with a colour one as three equal
/// channels.
Result<Difference> difference_between(const Picture& first, const Picture& second,
                                      double tolerance);
