#pragma once

#include "model/look/picture.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// What the numbers of a picture come to. A pixel with a number that is not finite is counted apart
/// and left out of all else.
struct Statistics {
    double minimum = 0.0;  // these three over all channels; 0 where no pixel is finite
    double maximum = 0.0;
    double mean = 0.0;
    std::size_t finite = 0;        // pixels
    std::size_t not_a_number = 0;  // with a NaN
    std::size_t infinite = 0;      // with an infinity and no NaN

    bool operator==(const Statistics&) const = default;
};

Statistics statistics_of(const Picture& picture);

/// How often numbers occur between two ends, in bins of equal width.
struct Histogram {
    std::vector<std::vector<std::uint32_t>> bins;  // of each channel
    std::uint32_t below = 0;                       // of all channels together
    std::uint32_t above = 0;
    std::uint32_t finite = 0;  // numbers, those outside included

    std::uint32_t highest() const;  // count of any bin
};

/// Of each channel on its own. `high` itself falls into the last bin; `low` lies below it. What is
/// not finite is not counted.
Histogram histogram_of(const Picture& picture, double low, double high, std::size_t bins);
