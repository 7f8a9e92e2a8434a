#pragma once

#include "model/look/extent.h"

#include <algorithm>

/// Where the lines of a source lie in the picture that shows it, in shares of the picture's height;
/// of its columns, in shares of the width.
struct RasterAxis {
    double start = 0.0;  // the top of the first line, from the picture's top; below 0 where cut
    double pitch = 1.0;  // from line to line
    int count = 1;       // of the source itself

    bool operator==(const RasterAxis&) const = default;
};

/// Both of a source.
struct SourceRaster {
    RasterAxis rows;
    RasterAxis columns;  // from the picture's left

    bool operator==(const SourceRaster&) const = default;
};

/// Of a source that fills the picture.
inline SourceRaster own_raster(Extent source) {
    const auto lines = [](int count) {
        return RasterAxis{0.0, 1.0 / std::max(count, 1), std::max(count, 1)};
    };
    return {lines(source.height), lines(source.width)};
}
