#pragma once

#include <algorithm>
#include <bit>

/// Whether a side of a texture has so many texels; some drivers make other code for it.
inline bool is_power_of_two(int length) {
    return std::has_single_bit(static_cast<unsigned>(std::max(length, 1)));
}
