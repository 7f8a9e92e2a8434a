#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

/// The distance between two pictures, in the units of their values, without alpha.
struct Distances {
    double mean = 0.0;          // of the absolute differences of all components
    double rms = 0.0;           // root of the mean square
    double largest = 0.0;       // NaN against a number is infinite
    double psnr_db = 0.0;       // for a peak of 1; infinite if equal
    double share_beyond = 0.0;  // of pixels with a component whose difference exceeds the tolerance
};

/// Distances, and the position of the largest one.
struct Difference : Distances {
    int largest_x = 0;  // px from the left
    int largest_y = 0;  // px from the top
};

/// Sums over the differences of all components of two pictures.
struct DifferenceSums {
    double absolute = 0.0;
    double squares = 0.0;
    double largest = 0.0;
    double beyond = 0.0;  // number of pixels beyond the tolerance
};
Distances distances_of(const DifferenceSums& sums, Extent extent, int channels);

/// Fails if the sizes differ. A grey picture is compared with a colour picture as three equal
/// channels.
Result<Difference> difference_between(const Picture& first, const Picture& second,
                                      double tolerance);

/// The absolute differences of all colours, multiplied by `gain`. Both pictures have the same size
/// and number of channels.
Picture difference_picture(const Picture& first, const Picture& second, double gain);

/// The largest power of two, at most 2^16, that keeps a difference within 1.
double gain_to_see(double largest);
