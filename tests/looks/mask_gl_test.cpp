// The masks of shaders/include/mask.glsl: over whole cells no light is lost in any channel.
#include "looks/glsl_function.h"

#include <doctest/doctest.h>

#include <cmath>
#include <span>

namespace {
/// x, y: the centre of a pixel; z: the kind of mask; w: its pitch.
constexpr const char* mask =
    "#include \"mask.glsl\"\nvec4 f(vec4 x) { return vec4(mask_light("
    "Mask(int(x.z), x.w, 1.0, 0.8, 0.5), x.xy, 1.0), 1.0); }\n";

std::vector<Vec4> pixels(int kind, double pitch, int width, int height) {
    std::vector<Vec4> centres;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            centres.push_back({x + 0.5, y + 0.5, static_cast<double>(kind), pitch});
    return centres;
}

Vec4 mean(std::span<const Vec4> values) {
    Vec4 sum{};
    for (const Vec4& value : values)
        for (std::size_t c = 0; c < 4; ++c)
            sum[c] += value[c] / static_cast<double>(values.size());
    return sum;
}

/// A whole number of cells horizontally and vertically; for hexagonal dots as close as pixels
/// allow.
std::vector<Vec4> whole_cells(int kind, double pitch) {
    if (kind != 3)
        return pixels(kind, pitch, static_cast<int>(std::lround(pitch * 20.0)),
                      static_cast<int>(std::lround(pitch * 10.0)));
    // 15 rows of two dots are 25.981 pitches high, and 26 pitches are 0.07 % more.
    return pixels(kind, pitch, static_cast<int>(std::lround(pitch * 10.0)),
                  static_cast<int>(std::lround(pitch * 15.0 * std::sqrt(3.0))));
}
}  // namespace

TEST_CASE("each channel of each mask has mean 1 over whole cells") {
    std::vector<std::vector<Vec4>> areas;
    std::vector<Vec4> inputs;
    for (int kind = 0; kind < 4; ++kind)
        for (const double pitch : {3.0, 4.3, 5.0, 7.7, 12.0, 18.0}) {
            areas.push_back(whole_cells(kind, pitch));
            inputs.insert(inputs.end(), areas.back().begin(), areas.back().end());
        }
    const auto drawn = run_glsl(mask, inputs);
    std::span<const Vec4> rest(drawn);
    for (const auto& area : areas) {
        CAPTURE(area.front()[2]);
        CAPTURE(area.front()[3]);
        const Vec4 light = mean(rest.first(area.size()));
        rest = rest.subspan(area.size());
        for (std::size_t c = 0; c < 3; ++c)
            CHECK(std::abs(light[c] - 1.0) < 0.005);
        CHECK(std::abs(light[0] - light[1]) < 0.005);
    }
}

TEST_CASE("stripes of the three channels do not overlap") {
    for (int kind = 0; kind < 3; ++kind) {
        int overlapping = 0;
        for (const Vec4& light : run_glsl(mask, pixels(kind, 12.0, 48, 24)))
            overlapping += (light[0] > 1e-4) + (light[1] > 1e-4) + (light[2] > 1e-4) == 1 ? 0 : 1;
        CHECK(overlapping == 0);
    }
}

TEST_CASE("dots of one colour form hexagons, with the other colours between them") {
    constexpr double pitch = 24.0;
    const double row = pitch * std::sqrt(3.0) / 2.0;
    // Centres of dots: red, red one row higher, green, blue.
    const auto drawn = run_glsl(
        "#include \"mask.glsl\"\nvec4 f(vec4 x) { Mask mask = Mask(3, 24.0, 1.0, 0.8, 0.5); "
        "return vec4(mask_light(mask, x.xy, 0.25) / mask_peak(mask), 1.0); }\n",
        std::vector<Vec4>{{2 * pitch, 2 * row, 0, 0},
                          {1.5 * pitch, row, 0, 0},
                          {1.5 * pitch, row / 3 + 2 * row, 0, 0},
                          {pitch, row * 2 / 3, 0, 0}});
    constexpr std::size_t colors[] = {0, 0, 1, 2};
    for (std::size_t i = 0; i < drawn.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            CHECK(std::abs(drawn[i][c] - (c == colors[i] ? 1.0 : 0.0)) < 0.01);
}

TEST_CASE("a pixel of a cell is the mean of the article's formula") {
    // Pixel (5, 1) of 12 px cells: green, from 1/4 to 2/4 of its stripe and 1/12 to 2/12 of the
    // cell's height.
    const auto over = [](double low, double high) {
        return 1.0 - 0.8 * (high * high * high - low * low * low) / 3.0 / (high - low);
    };
    const double expected =
        3.0 * over(-0.5, 0.0) * over(-5.0 / 6.0, -4.0 / 6.0) / std::pow(1.0 - 0.8 / 3.0, 2.0);
    // The next column is half a cell higher: its pixel 6 px further up is the same.
    for (const Vec4& light :
         run_glsl(mask, std::vector<Vec4>{{5.5, 1.5, 0, 12}, {17.5, 7.5, 0, 12}}))
        CHECK(std::abs(light[1] - expected) < 1e-4);
}

TEST_CASE("a mask finer than 2 px is uniform") {
    for (int kind = 0; kind < 4; ++kind) {
        std::size_t even = 0;
        for (const Vec4& light : run_glsl(mask, pixels(kind, 1.9, 16, 16)))
            even += light == Vec4{1.0, 1.0, 1.0, 1.0} ? 1u : 0u;
        CHECK(even == 256);
    }
}

TEST_CASE("a cell is sampled at its centre, in every column") {
    for (int kind = 0; kind < 3; ++kind) {
        CAPTURE(kind);
        const auto pixel = pixels(kind, 12.0, 24, 24);
        const auto centres = run_glsl(
            "#include \"mask.glsl\"\nvec4 f(vec4 x) { return vec4(mask_cell_centre("
            "Mask(int(x.z), x.w, 1.0, 0.8, 0.5), x.xy), 0, 0); }\n",
            pixel);
        bool is_middle = true;
        for (std::size_t i = 0; i < pixel.size(); ++i) {
            const Vec4& centre = centres[i];
            const double expected_y = kind == 1 ? pixel[i][1] : centre[0] < 12.0 ? 6.0 : 0.0;
            is_middle = is_middle && std::abs(centre[0] - pixel[i][0]) <= 6.0 &&
                        std::abs(centre[1] - pixel[i][1]) <= 6.0 &&
                        std::fmod(centre[0], 12.0) == 6.0 &&
                        (kind == 1 ? centre[1] == expected_y
                                   : std::fmod(centre[1] + 12.0, 12.0) == expected_y);
        }
        CHECK(is_middle);
    }
}

TEST_CASE("a triad of dots is sampled at its centre, and odd rows are shifted by half a triad") {
    const double row = 12.0 * std::sqrt(3.0) / 2.0;
    const auto pixel = pixels(3, 12.0, 48, 48);
    const auto centres = run_glsl(
        "#include \"mask.glsl\"\nvec4 f(vec4 x) { return vec4(mask_cell_centre("
        "Mask(3, 12.0, 1.0, 0.8, 0.5), x.xy), 0, 0); }\n",
        pixel);
    int off = 0;
    for (std::size_t i = 0; i < pixel.size(); ++i) {
        const double up = std::floor(pixel[i][1] / row);
        const double shift = std::fmod(up, 2.0) == 1.0 ? 6.0 : 0.0;
        const double along = std::floor((pixel[i][0] - shift) / 12.0);
        const bool is_middle = std::abs(centres[i][0] - (12.0 * along + shift + 6.0)) < 1e-4 &&
                               std::abs(centres[i][1] - (up + 0.5) * row) < 1e-4;
        off += is_middle ? 0 : 1;
    }
    CHECK(off == 0);
}
