#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

/// How far two pictures are apart, in the units of their values; alpha does not count.
struct Distances {
    double mean = 0.0;          // of the absolute differences of all components
    double rms = 0.0;           // root of the mean square
    double largest = 0.0;       // NaN against a number counts as infinite
    double psnr_db = 0.0;       // for a peak of 1; infinite when equal
    double share_beyond = 0.0;  // of the pixels with a component farther apart than the tolerance
};

/// Distances, and where the largest is.
struct Difference : Distances {
    int largest_x = 0;  // px from the left
    int largest_y = 0;  // px from the top
};

/// What the differences of all components of two pictures add up to.
struct DifferenceSums {
    double absolute = 0.0;
    double squares = 0.0;
    double largest = 0.0;
    double beyond = 0.0;  // pixels
};
Distances distances_of(const DifferenceSums& sums, Extent extent, int channels);

/// Fails when sizes or channels differ. A grey picture compares with a colour one as three equal
/// channels.
Result<Difference> difference_between(const Picture& first, const Picture& second,
                                      double tolerance);

/// The absolute differences of all colours, `gain` times, of two pictures of one size and as many
/// channels each.
Picture difference_picture(const Picture& first, const Picture& second, double gain);

/// The largest power of two, at most 2^16, by which a difference stays within 1.
double gain_to_see(double largest);
