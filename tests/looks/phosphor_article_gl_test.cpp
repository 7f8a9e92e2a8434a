// Phosphor as written in the article, compared with the article's own formulas.
#include "about.h"
#include "looks/tube.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
constexpr Extent extent{102, 90};

Values as_written(const Values& more = {}) {
    return with(with(plain_glass(), {{"as_written", Value(1.0)}}), more);
}

double smoothstep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The distance from the middle of a division.
double away(double place) {
    return std::abs(place - std::floor(place) - 0.5);
}

}  // namespace

TEST_CASE("the article's light decays per frame, regardless of frame length and point age") {
    Tube tube(as_written({{"decay", Value(0.9)}}), extent);
    tube.draw({{0.0f, 0.0f, 0.01f, 0.0f}}, 24.0);
    const double fresh = tube.sum("persistence");
    tube.rest(1, 24.0);
    CHECK(is_near(tube.sum("persistence") / fresh, 0.9, 1e-5));
    tube.rest(1, 240.0);
    CHECK(is_near(tube.sum("persistence") / fresh, 0.81, 1e-5));
    tube.restart(as_written({{"decay", Value(0.9)}}));
    tube.draw({{0.0f, 0.0f, 0.01f, 0.03f}}, 24.0);
    CHECK(is_near(tube.sum("persistence") / fresh, 1.0, 1e-5));
}

TEST_CASE("the article's ceiling clips each channel separately") {
    Tube tube(as_written({{"ceiling", Value(2.5)},
                          {"beam_color", Value(std::vector<double>{0.2, 1.0, 0.3})}}),
              extent);
    tube.draw(tube.flood());
    for (std::size_t channel = 0; channel < 3; ++channel)
        CHECK(is_near(tube.at("reduced", 25, 22, channel), 2.5, 1e-6));
}

TEST_CASE("the article's spot is point-sampled, and cut to a square of at most twice its width") {
    const double width = 10.0;
    for (const int height : {512, 2048}) {
        CAPTURE(height);
        Tube tube(as_written({{"beam_width", Value(width)}, {"beam_gain", Value(0.7)}}),
                  {64, height});
        tube.draw({{0.0f, 0.0f, 1.0f, 0.0f}});
        const double side = height == 512 ? width : 2.0 * width;
        const Picture beam = tube.target("beam");
        const auto lit = std::count_if(beam.pixels.begin(), beam.pixels.end(),
                                       [](float value) { return value > 0.0f; });
        CHECK(lit == static_cast<long>(side * side) * 4);  // red, green, blue and the count
        const double place = 2.5 / side;                   // of the third pixel, in widths
        const double square = 2.0 * place * place;
        CHECK(is_near(tube.at("beam", 34, height / 2 - 3),
                      0.7 * (std::exp(-28.0 * square) + 0.3 * std::exp(-8.0 * square)), 1e-5));
    }
}

TEST_CASE("the article's blur samples its table at whole taps") {
    constexpr std::array<double, 7> table{0.19648255, 0.29690696, 0.21959561, 0.04393693,
                                          0.01096343, 0.00183638, 0.00021493};
    const double all =
        table[0] + 2.0 * (table[1] + table[2] + table[3] + table[4] + table[5] + table[6]);
    constexpr int radius = 3;
    Tube tube(as_written({{"bloom_kind", Value(0.0)},
                          {"bloom_radius", Value(static_cast<double>(radius))},
                          {"beam_width", Value(64.0)}}),
              {128, 16});
    // A square of 2 x 2 px is one texel of the half-size picture.
    tube.draw({{-1.0f / 128.0f + 2.0f / 128.0f, 1.0f / 8.0f, 1.0f, 0.0f}});
    const Picture light = tube.target("persistence");
    const Picture bloom = tube.target("bloom_x");
    const auto half = [&light](int x, int y) {
        double sum = 0.0;
        for (int i = 0; i < 4; ++i) {
            const int at = 2 * x + i % 2;
            if (at >= 0 && at < light.extent.width)
                sum += static_cast<double>(light.pixels[light.index(at, 2 * y + i / 2) + 1]);
        }
        return sum / 4.0;
    };
    for (const int x : {32, 33, 35, 38, 41}) {
        CAPTURE(x);
        double expected = 0.0;
        for (int i = -6; i <= 6; ++i)
            expected += table[static_cast<std::size_t>(std::abs(i))] * half(x + i * radius, 3);
        const auto shown = static_cast<double>(bloom.pixels[bloom.index(x, 3) + 1]);
        CHECK(is_near(shown, expected / all, 1e-5));
    }
}

TEST_CASE("the article's glass: scanlines, graticule, vignette and room light") {
    const double light = 3.75 / 4.75;  // Reinhard of 2.5 x 1.5
    Tube tube({}, extent);
    const auto shown = [&tube](const Values& values, int x, int y) {
        tube.restart(as_written(values));
        tube.draw(tube.flood());
        return tube.at("composite", x, y);
    };
    const Values lines{{"scanline_strength", Value(0.3)}, {"scanline_period", Value(8.0)}};
    const Values grid{{"graticule", Value(0.2)},
                      {"graticule_divisions", Value(std::vector<double>{10, 10})}};
    CHECK(is_near(shown({}, 50, 45), light, 1e-5));
    const double up = 90.0 - 45.5;  // px from the bottom
    const double wave = std::sin(2.0 * std::acos(-1.0) * up / 8.0);
    CHECK(is_near(shown(lines, 50, 45), light * (1.0 - 0.3 * (0.5 + 0.5 * wave)), 1e-4));
    for (const int x : {25, 26, 30}) {  // 25: on the article's axis, at a quarter of the width
        CAPTURE(x);
        const double at = (x + 0.5) / 102.0;
        const double above = up / 90.0;
        const double clear =
            smoothstep(0.0, 0.06, away(10.0 * at)) * smoothstep(0.0, 0.06, away(10.0 * above));
        const double axes = 1.0 - smoothstep(0.0, 0.003, away(2.0 * at));
        const double expected = light * (0.8 + 0.2 * clear) * (1.0 - 1.5 * 0.2 * axes);
        CHECK(is_near(shown(grid, x, 45), expected, 1e-4));
    }
    const double right = 92.5 / 102.0 - 0.5;
    const double low = 80.5 / 90.0 - 0.5;
    const double rest = 1.0 - 0.9 * (right * right + low * low);
    CHECK(is_near(shown({{"vignette", Value(0.9)}}, 92, 80), light * smoothstep(0.0, 1.0, rest),
                  1e-4));
    const Value room(std::vector<double>{0.0, 0.1, 0.0});
    CHECK(is_near(shown({{"ambient_glass", room}}, 50, 45), light + 0.1, 1e-5));
    CHECK(shown({{"ambient_glass", room}, {"curvature", Value(0.3)}}, 101, 89) == 0.0);
}

TEST_CASE("with tone mapping in every frame, the phosphor stores and shows Reinhard's value") {
    Tube tube({}, extent);
    for (const double written : {0.0, 1.0}) {
        CAPTURE(written);
        tube.restart(with(plain_glass(),
                          {{"as_written", Value(written)}, {"tone_map_every_frame", Value(1.0)}}));
        tube.draw(tube.flood());
        CHECK(is_near(tube.at("persistence", 50, 45), 2.5 / 3.5, 1e-6));
        CHECK(is_near(tube.at("composite", 50, 45), 2.5 / 3.5, 1e-6));
    }
}
