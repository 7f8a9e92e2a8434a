#pragma once

#include <algorithm>
#include <bit>

/// Whether a side of a texture is a power of two, for which some drivers compile separately.
inline bool is_power_of_two(int length) {
    return std::has_single_bit(static_cast<unsigned>(std::max(length, 1)));
}
