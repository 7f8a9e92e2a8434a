#pragma once

#include "model/look/extent.h"

#include <algorithm>

/// The position of a source's lines in the picture that shows it, relative to the picture's height;
/// of its columns, relative to the width.
struct RasterAxis {
    double start = 0.0;  // top of the first line from the picture's top; negative if cropped
    double pitch = 1.0;  // from line to line
    int count = 1;       // of the source

    bool operator==(const RasterAxis&) const = default;
};

/// Rows and columns of a source.
struct SourceRaster {
    RasterAxis rows;
    RasterAxis columns;  // from the picture's left

    bool operator==(const SourceRaster&) const = default;
};

/// For a source that fills the picture.
inline SourceRaster own_raster(Extent source) {
    const auto lines = [](int count) {
        return RasterAxis{0.0, 1.0 / std::max(count, 1), std::max(count, 1)};
    };
    return {lines(source.height), lines(source.width)};
}
