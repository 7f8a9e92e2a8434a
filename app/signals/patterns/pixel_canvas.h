#pragma once

#include "model/look/picture.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

/// Pixels that hold the numbers of a small palette, drawn on as on an old machine: every shape has
/// hard edges, and shades between two colours are dithered. (0, 0) is the top left pixel.
class PixelCanvas {
public:
    using Color = std::uint32_t;  // 0xRRGGBB, display values
    using Index = std::uint8_t;   // into the palette

    PixelCanvas(Extent extent, std::vector<Color> palette);

    int width() const { return m_extent.width; }
    int height() const { return m_extent.height; }
    Index at(int x, int y) const;
    void set(int x, int y, Index color);
    void rectangle(int x, int y, int width, int height, Index color);
    void disc(double x, double y, double radius, Index color);
    void line(int x0, int y0, int x1, int y1, Index color);
    /// A letter a pixel: 'a' is color 0, 'b' color 1, ...; any other sign leaves what is there.
    void sprite(int x, int y, std::span<const std::string_view> rows);
    /// One of the two colours, the second in `share` of all pixels, by a 4 x 4 Bayer matrix.
    void dithered(int x, int y, Index first, Index second, double share);

    Picture picture() const;

private:
    Extent m_extent;
    std::vector<Color> m_palette;
    std::vector<Index> m_pixels;
};
