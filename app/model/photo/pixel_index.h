#pragma once

#include "model/look/extent.h"

#include <algorithm>
#include <cstddef>

/// The index of a pixel in rows from the top. Outside, the nearest pixel counts.
inline std::size_t pixel_index(Extent extent, int x, int y) {
    const int column = std::clamp(x, 0, extent.width - 1);
    const int row = std::clamp(y, 0, extent.height - 1);
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(extent.width) +
           static_cast<std::size_t>(column);
}
