#include "signals/patterns/glyph_rain.h"

#include "signals/patterns/bitmap_font.h"
#include "signals/patterns/hash.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
using Color = std::array<float, 3>;

constexpr int cell_width = 8;    // dots
constexpr int cell_height = 10;  // dots
constexpr Color head_color{0.65f, 1.0f, 0.75f};
constexpr Color trail_color{0.10f, 0.85f, 0.24f};
constexpr int drops_per_column = 2;

/// A run of glyphs that falls down a column repeatedly.
struct Drop {
    double speed = 0.0;   // cells per second
    double length = 0.0;  // of the trail, cells
    double way = 0.0;     // cells between starts: the rows and a pause
    double begin = 0.0;   // cells
    double light = 0.0;   // brightness factor; dimmer drops look more distant
};

Drop drop_of(std::uint32_t column, std::uint32_t index, int rows) {
    const auto share = [&](std::uint32_t which) { return hash_to_unit(column, index, which); };
    Drop drop;
    drop.speed = 5.0 + 11.0 * share(0) * share(0);
    drop.length = rows * (0.25 + 0.55 * share(1));
    drop.way = rows + drop.length + rows * 0.9 * share(2);
    drop.begin = drop.way * share(3);
    drop.light = share(4) < 0.45 ? 0.35 : 1.0;
    return drop;
}

/// Brightness of a cell: 1 at the head of a drop, decreasing along its trail.
struct Glow {
    float trail = 0.0f;
    float head = 0.0f;
};

Glow glow_at(const std::array<Drop, drops_per_column>& drops, int row, double seconds) {
    Glow glow;
    for (const Drop& drop : drops) {
        const double head = std::fmod(drop.begin + drop.speed * seconds, drop.way);
        const double behind = std::floor(head) - row;
        if (behind < 0.0 || behind > drop.length)
            continue;
        if (behind == 0.0 && drop.light == 1.0)
            glow.head = 1.0f;
        const double left = 1.0 - behind / drop.length;
        glow.trail =
            std::max(glow.trail, static_cast<float>(0.9 * drop.light * left * std::sqrt(left)));
    }
    return glow;
}

// The glyph of a cell changes about once per second, at times that differ between cells.
char glyph_at(std::uint32_t column, std::uint32_t row, double seconds) {
    const double pace = 0.4 + 1.6 * hash_to_unit(column, row, 11);
    const double turn = std::floor(seconds * pace + hash_to_unit(column, row, 12));
    constexpr int glyphs = 60;  // from '!' on: punctuation, digits, capitals
    return static_cast<char>('!' +
                             hash_of(column, row, 100 + static_cast<std::uint32_t>(turn)) % glyphs);
}

/// Position of the cells: each dot is `dot` px wide, with a margin on each side.
struct Layout {
    int dot = 1;
    int columns = 0;
    int rows = 0;
};

Layout layout_of(Extent extent) {
    const int dot = std::max(1, (extent.height + 180) / 360);
    return {dot, extent.width / (cell_width * dot) + 1, extent.height / (cell_height * dot) + 1};
}

// Mirrored, so that the glyphs look like an unknown script.
void draw_glyph(Picture& picture, const Layout& layout, int column, int row, char glyph,
                const Color& light) {
    const int left = (column * cell_width + 1) * layout.dot;
    const int top = (row * cell_height + 1) * layout.dot;
    const auto width = bitmap_font::width * layout.dot;
    const auto height = bitmap_font::height * layout.dot;
    for (int y = 0; y < height && top + y < picture.extent.height; ++y)
        for (int x = 0; x < width && left + x < picture.extent.width; ++x)
            if (bitmap_font::has_dot(glyph, bitmap_font::width - 1 - x / layout.dot,
                                     y / layout.dot))
                std::ranges::copy(
                    light, picture.pixels.begin() +
                               static_cast<std::ptrdiff_t>(picture.index(left + x, top + y)));
}

void draw_rain(Picture& picture, double seconds) {
    const Layout layout = layout_of(picture.extent);
    for (int column = 0; column < layout.columns; ++column) {
        const auto key = static_cast<std::uint32_t>(column);
        std::array<Drop, drops_per_column> drops;
        for (std::uint32_t i = 0; i < drops_per_column; ++i)
            drops[i] = drop_of(key, i, layout.rows);
        for (int row = 0; row < layout.rows; ++row) {
            const Glow glow = glow_at(drops, row, seconds);
            if (glow.trail <= 0.0f)
                continue;
            Color light;
            for (std::size_t c = 0; c < 3; ++c)
                light[c] = std::max(trail_color[c] * glow.trail, head_color[c] * glow.head);
            draw_glyph(picture, layout, column, row,
                       glyph_at(key, static_cast<std::uint32_t>(row), seconds), light);
        }
    }
}

/// The picture at a quarter of its size, for a wide, soft bloom.
Picture quartered(const Picture& picture) {
    const Extent extent{(picture.extent.width + 3) / 4, (picture.extent.height + 3) / 4};
    Picture small{extent, 3, Encoding::linear, {}};
    small.pixels.resize(small.index(0, extent.height));
    for (int y = 0; y < picture.extent.height; ++y)
        for (int x = 0; x < picture.extent.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                small.pixels[small.index(x / 4, y / 4) + c] +=
                    picture.pixels[picture.index(x, y) + c] / 16.0f;
    return small;
}

// A running mean along one axis. Three passes approximate a Gaussian (P. Kovesi, "Fast
// Almost-Gaussian Filtering", DICTA 2010). Black outside the picture.
void blur_line(const float* from, float* to, int count, std::size_t step, int reach) {
    const float share = 1.0f / static_cast<float>(2 * reach + 1);
    float sum = 0.0f;
    const auto value = [&](int i) {
        return i < 0 || i >= count ? 0.0f : from[static_cast<std::size_t>(i) * step];
    };
    for (int i = -reach; i < reach; ++i)
        sum += value(i);
    for (int i = 0; i < count; ++i) {
        sum += value(i + reach);
        to[static_cast<std::size_t>(i) * step] = std::max(0.0f, sum * share);
        sum -= value(i - reach);
    }
}

void blur(Picture& picture, int reach) {
    std::vector<float> other(picture.pixels.size());
    const auto [width, height] = picture.extent;
    const std::size_t row = picture.index(0, 1);
    for (int pass = 0; pass < 3; ++pass) {
        for (int y = 0; y < height; ++y)
            for (std::size_t c = 0; c < 3; ++c)
                blur_line(picture.pixels.data() + picture.index(0, y) + c,
                          other.data() + picture.index(0, y) + c, width, 3, reach);
        for (std::size_t x = 0; x < row; ++x)
            blur_line(other.data() + x, picture.pixels.data() + x, height, row, reach);
    }
}

float between(float low, float high, float share) {
    return low + (high - low) * share;
}

/// Adds the small picture with bilinear interpolation.
void add_bloom(Picture& picture, const Picture& small, float strength) {
    const auto span_of = [](int at, int length) {
        const float from = std::clamp((static_cast<float>(at) + 0.5f) / 4.0f - 0.5f, 0.0f,
                                      static_cast<float>(length - 1));
        const int low = static_cast<int>(from);
        return std::pair{low, from - static_cast<float>(low)};
    };
    for (int y = 0; y < picture.extent.height; ++y) {
        const auto [top, down] = span_of(y, small.extent.height);
        const int below = std::min(top + 1, small.extent.height - 1);
        for (int x = 0; x < picture.extent.width; ++x) {
            const auto [left, along] = span_of(x, small.extent.width);
            const int right = std::min(left + 1, small.extent.width - 1);
            for (std::size_t c = 0; c < 3; ++c) {
                const auto at = [&](int sx, int sy) {
                    return small.pixels[small.index(sx, sy) + c];
                };
                const float above = between(at(left, top), at(right, top), along);
                const float under = between(at(left, below), at(right, below), along);
                picture.pixels[picture.index(x, y) + c] += strength * between(above, under, down);
            }
        }
    }
}

Picture drawn_rain(Extent extent, double seconds) {
    Picture picture{extent, 3, Encoding::linear, {}};
    picture.pixels.resize(picture.index(0, extent.height));
    draw_rain(picture, seconds);
    Picture small = quartered(picture);
    blur(small, std::max(1, extent.height / 360));
    add_bloom(picture, small, 1.6f);
    return picture;
}
}  // namespace

Pattern glyph_rain_pattern() {
    return {{"glyph-rain", "Glyph rain",
             "Falling glyphs with bloom, in linear light. The heads are brighter than 1.", true},
            {1280, 720},
            drawn_rain};
}
