#pragma once

#include "model/look/extent.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// Whether values are linear light or display-encoded (sRGB).
enum class Encoding { linear, display };

/// The row of a texture at v = 0: the bottom in GL, the top in files and in shaders made for
/// Vulkan.
enum class RowOrder { bottom_first, top_first };

/// The layout of a picture's rows. cube: six square faces, stacked in the order +x -x +y -y +z -z.
/// volume: square slices, stacked, their number equal to their width.
enum class PictureShape { flat, cube, volume };

/// Pixels in memory: floats, interleaved channels, row 0 at the top. Those of a live source can be
/// bytes instead, which are converted when they are uploaded.
struct Picture {
    Extent extent;
    int channels = 4;  // 1 grey, 3 RGB, 4 RGBA (unassociated alpha)
    Encoding encoding = Encoding::linear;
    std::vector<float> pixels;  // extent.height rows of extent.width * channels
    PictureShape shape = PictureShape::flat;
    std::string note = {};  // problem of the file that it was read from; "": no problem
    // 4 bytes per pixel, in this order: blue, green, red, unused. Then `pixels` is empty and
    // `channels` is 4. Null: the picture has floats.
    std::shared_ptr<const std::uint8_t> bytes = nullptr;

    bool operator==(const Picture&) const = default;
    std::size_t index(int x, int y) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(extent.width) +
                static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels);
    }
};
