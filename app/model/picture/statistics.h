#pragma once

#include "model/look/picture.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// Statistics of a picture's values. A pixel with a non-finite value is only counted, and left out
/// of everything else.
struct Statistics {
    double minimum = 0.0;  // these three over all channels; 0 without finite pixels
    double maximum = 0.0;
    double mean = 0.0;
    std::size_t finite = 0;        // pixels
    std::size_t not_a_number = 0;  // with a NaN
    std::size_t infinite = 0;      // with an infinity and no NaN

    bool operator==(const Statistics&) const = default;
};

Statistics statistics_of(const Picture& picture);

/// Counts of values in a range, in bins of equal width.
struct Histogram {
    std::vector<std::vector<std::uint32_t>> bins;  // per channel
    std::uint32_t below = 0;                       // of all channels
    std::uint32_t above = 0;
    std::uint32_t finite = 0;  // values, including those out of range

    std::uint32_t highest() const;  // largest count of any bin
};

/// Per channel. `high` is in the last bin; values below `low` are counted as below. Non-finite
/// values are not counted.
Histogram histogram_of(const Picture& picture, double low, double high, std::size_t bins);
