#pragma once

#include "model/look/extent.h"

#include <cstddef>
#include <string>
#include <vector>

/// Whether numbers are amounts of light or what a display is sent (sRGB).
enum class Encoding { linear, display };

/// Which row of a texture comes first, at v = 0: GL's own order, or that of files and of shaders
/// made for Vulkan.
enum class RowOrder { bottom_first, top_first };

/// What a picture's rows are: one picture; the faces of a cube, one below the other, +x -x +y -y +z
/// -z, each as wide as high; or the slices of a volume, likewise, as many as one is wide.
enum class PictureShape { flat, cube, volume };

/// Pixels in memory: floats, interleaved channels, row 0 on top.
struct Picture {
    Extent extent;
    int channels = 4;  // 1 grey, 3 RGB, 4 RGBA (unassociated alpha)
    Encoding encoding = Encoding::linear;
    std::vector<float> pixels;  // extent.height rows of extent.width * channels
    PictureShape shape = PictureShape::flat;
    std::string note = {};  // what is amiss with the file that it was read from; "": nothing

    bool operator==(const Picture&) const = default;
    std::size_t index(int x, int y) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(extent.width) +
                static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels);
    }
};
