#include "signals/patterns/test_cards.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace {
using Color = std::array<float, 3>;

/// Position of a pixel's centre: 0..1 from the left and from the top, and in pixels.
struct PixelPosition {
    double u = 0.0;
    double v = 0.0;
    int x = 0;
    int y = 0;
    Extent extent;
};

constexpr float three_quarters = 0.75f;
constexpr Color black{0.0f, 0.0f, 0.0f};
constexpr Color white{1.0f, 1.0f, 1.0f};

Color grey(double level) {
    const auto light = static_cast<float>(level);
    return {light, light, light};
}

// Seven bars from grey to blue. Green changes every four bars, red every two, blue every bar.
Color bar(int index) {
    const int code = 7 - index;
    return {(code & 2) ? three_quarters : 0.0f, (code & 4) ? three_quarters : 0.0f,
            (code & 1) ? three_quarters : 0.0f};
}

// SMPTE EG 1-1990: colour bars over reversed blue bars over -I, white, +Q and the black-level
// steps.
Color smpte(const PixelPosition& position) {
    const int column = static_cast<int>(position.u * 7.0);
    if (position.v < 2.0 / 3.0)
        return bar(column);
    if (position.v < 3.0 / 4.0)
        return column % 2 == 0 ? bar(6 - column) : black;
    const double sixths = position.u * 7.0 * 4.0 / 5.0;  // four boxes over the first five bars
    if (sixths < 1.0)
        return {0.0f, 0.129f, 0.298f};  // -I
    if (sixths < 2.0)
        return white;
    if (sixths < 3.0)
        return {0.196f, 0.0f, 0.416f};  // +Q
    if (column == 5) {
        constexpr std::array steps{0.0f, 0.0f, 0.04f};  // levels below black cannot be shown
        return grey(steps[static_cast<std::size_t>((position.u * 7.0 - 5.0) * 3.0)]);
    }
    return black;
}

Color ramp(const PixelPosition& position) {
    return grey(position.u);
}

// Grey, red, green, blue, and grey in 16 steps.
Color ramps(const PixelPosition& position) {
    const int band = static_cast<int>(position.v * 5.0);
    const auto level = static_cast<float>(position.u);
    if (band == 0)
        return grey(position.u);
    if (band == 4)
        return grey(std::floor(position.u * 16.0) / 15.0);
    Color color = black;
    color[static_cast<std::size_t>(band - 1)] = level;
    return color;
}

bool is_on_line(int at, int length, int pitch) {
    return (at - length / 2) % pitch == 0;
}

Color crosshatch(const PixelPosition& position) {
    constexpr int pitch = 40;
    return is_on_line(position.x, position.extent.width, pitch) ||
                   is_on_line(position.y, position.extent.height, pitch)
               ? white
               : black;
}

// Coverage of a pixel by a ring 2 px wide.
double ring(const PixelPosition& position, double radius) {
    const double x = position.x + 0.5 - 0.5 * position.extent.width;
    const double y = position.y + 0.5 - 0.5 * position.extent.height;
    return std::clamp(1.5 - std::abs(std::hypot(x, y) - radius), 0.0, 1.0);
}

// A square grid, twelve cells high. The circle touches top and bottom, smaller circles touch the
// corners of the cells around the centre.
Color grid(const PixelPosition& position) {
    const double mesh = position.extent.height / 12.0;
    const auto is_on = [mesh](int at, int length) {
        const double from_middle = at + 0.5 - 0.5 * length;
        return std::abs(from_middle - std::round(from_middle / mesh) * mesh) < 0.51;
    };
    const double lines =
        is_on(position.x, position.extent.width) || is_on(position.y, position.extent.height) ? 0.5
                                                                                              : 0.0;
    const double circles = std::max(ring(position, 6.0 * mesh - 1.5), ring(position, 2.0 * mesh));
    const double level = 0.12 + (0.75 - 0.12) * lines * 2.0;
    return grey(std::max(level, circles));
}

Color dots(const PixelPosition& position) {
    constexpr int pitch = 20;
    return position.x % pitch == pitch / 2 && position.y % pitch == pitch / 2 ? white : black;
}

Color dot(const PixelPosition& position) {
    return position.x == position.extent.width / 2 && position.y == position.extent.height / 2
               ? white
               : black;
}

Color checker(const PixelPosition& position) {
    return (position.x + position.y) % 2 == 0 ? white : black;
}

// Concentric rings with r / width periods per pixel, up to the finest that pixels can show at the
// sides. Rings with other centres are aliasing of the look under test.
Color zone_plate(const PixelPosition& position) {
    const int x_from_middle = position.x - position.extent.width / 2;
    const int y_from_middle = position.y - position.extent.height / 2;
    const double x = x_from_middle;
    const double y = y_from_middle;
    const double width = std::max(position.extent.width, position.extent.height);
    return grey(0.5 + 0.5 * std::cos(std::numbers::pi * (x * x + y * y) / width));
}

Color field(const PixelPosition&) {
    return white;
}

template <Color (*color)(const PixelPosition&)>
Picture drawn_card(Extent extent, double /*seconds*/) {
    Picture picture{extent, 3, Encoding::display, {}};
    picture.pixels.reserve(picture.index(0, extent.height));
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x) {
            const Color pixel =
                color({(x + 0.5) / extent.width, (y + 0.5) / extent.height, x, y, extent});
            picture.pixels.insert(picture.pixels.end(), pixel.begin(), pixel.end());
        }
    return picture;
}
}  // namespace

std::vector<Pattern> test_cards() {
    constexpr Extent vga{640, 480};
    return {
        {{"smpte", "SMPTE bars", "Colour bars at 75 %, -I, white, +Q and black steps."},
         vga,
         drawn_card<smpte>},
        {{"ramp", "Grey ramp", "Black to white from left to right."}, vga, drawn_card<ramp>},
        {{"ramps", "Ramps", "Ramps from black to grey, red, green and blue, and grey in 16 steps."},
         vga,
         drawn_card<ramps>},
        {{"grid", "Grid with circle",
          "Square grid and a circle, for geometry. Distortion bends the lines."},
         vga,
         drawn_card<grid>},
        {{"crosshatch", "Crosshatch", "White lines 40 px apart, for convergence."},
         vga,
         drawn_card<crosshatch>},
        {{"dot", "Single dot", "One white pixel in the middle, for focus and bloom."},
         vga,
         drawn_card<dot>},
        {{"dots", "Dots", "Single white pixels 20 px apart, for focus and glow."},
         vga,
         drawn_card<dots>},
        {{"checker", "Checkerboard", "Alternating black and white pixels, the finest detail."},
         vga,
         drawn_card<checker>},
        {{"zone-plate", "Zone plate",
          "Rings that get finer towards the edge. Moiré shows as extra rings."},
         {480, 480},
         drawn_card<zone_plate>},
        {{"white", "White field", "All white, for masks, purity and brightness."},
         vga,
         drawn_card<field>},
    };
}
