#include "signals/patterns/pixel_canvas.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

PixelCanvas::PixelCanvas(Extent extent, std::vector<Color> palette)
    : m_extent(extent),
      m_palette(std::move(palette)),
      m_pixels(static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(extent.height)) {}

PixelCanvas::Index PixelCanvas::at(int x, int y) const {
    x = std::clamp(x, 0, m_extent.width - 1);
    y = std::clamp(y, 0, m_extent.height - 1);
    return m_pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_extent.width) +
                    static_cast<std::size_t>(x)];
}

void PixelCanvas::set(int x, int y, Index color) {
    if (x < 0 || y < 0 || x >= m_extent.width || y >= m_extent.height)
        return;
    m_pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_extent.width) +
             static_cast<std::size_t>(x)] = color;
}

void PixelCanvas::rectangle(int x, int y, int width, int height, Index color) {
    for (int row = y; row < y + height; ++row)
        for (int column = x; column < x + width; ++column)
            set(column, row, color);
}

void PixelCanvas::disc(double x, double y, double radius, Index color) {
    const int reach = static_cast<int>(std::ceil(radius));
    for (int row = -reach; row <= reach; ++row)
        for (int column = -reach; column <= reach; ++column)
            if (column * column + row * row <= radius * radius)
                set(static_cast<int>(x) + column, static_cast<int>(y) + row, color);
}

void PixelCanvas::line(int x0, int y0, int x1, int y1, Index color) {
    const int steps = std::max({std::abs(x1 - x0), std::abs(y1 - y0), 1});
    for (int i = 0; i <= steps; ++i)
        set(x0 + static_cast<int>(std::lround((x1 - x0) * static_cast<double>(i) / steps)),
            y0 + static_cast<int>(std::lround((y1 - y0) * static_cast<double>(i) / steps)), color);
}

void PixelCanvas::sprite(int x, int y, std::span<const std::string_view> rows) {
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (std::size_t column = 0; column < rows[row].size(); ++column) {
            const char letter = rows[row][column];
            if (letter >= 'a' && letter - 'a' < static_cast<int>(m_palette.size()))
                set(x + static_cast<int>(column), y + static_cast<int>(row),
                    static_cast<Index>(letter - 'a'));
        }
}

void PixelCanvas::dithered(int x, int y, Index first, Index second, double share) {
    constexpr std::array<int, 16> bayer{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
    const double threshold =
        (bayer[4 * static_cast<std::size_t>(y & 3) + static_cast<std::size_t>(x & 3)] + 0.5) / 16.0;
    set(x, y, share > threshold ? second : first);
}

Picture PixelCanvas::picture() const {
    Picture picture{m_extent, 3, Encoding::display, {}};
    picture.pixels.reserve(m_pixels.size() * 3);
    for (const Index index : m_pixels)
        for (const unsigned shift : {16u, 8u, 0u})
            picture.pixels.push_back(static_cast<float>((m_palette[index] >> shift) & 255u) /
                                     255.0f);
    return picture;
}
