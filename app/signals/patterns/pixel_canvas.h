#pragma once

#include "model/look/picture.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

/// A picture of indices into a small palette. Shapes have hard edges, and shades between two
/// colours are dithered. (0, 0) is the top left pixel.
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
    /// One letter per pixel: 'a' is colour 0, 'b' colour 1, ...; other characters are transparent.
    void sprite(int x, int y, std::span<const std::string_view> rows);
    /// Dithers two colours with a 4 x 4 Bayer matrix; `share` is the fraction of pixels of the
    /// second.
    void dithered(int x, int y, Index first, Index second, double share);

    Picture picture() const;

private:
    Extent m_extent;
    std::vector<Color> m_palette;
    std::vector<Index> m_pixels;
};
