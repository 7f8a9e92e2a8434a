// Phosphor's beam drawn as segments, compared with the stated energy and with points.
#include "looks/tube.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

namespace {
constexpr Extent extent{96, 96};

Values as_segments(const Values& more = {}) {
    return with({{"beam_kind", Value(1.0)},
                 {"beam_width", Value(16.0)},
                 {"beam_color", Value(std::vector<double>{1, 1, 1})},
                 {"beam_gain", Value(0.01)},
                 {"ceiling", Value(1000.0)}},
                more);
}

/// From one position to another in `seconds`, ending `age` before the end of the frame, in equal
/// pieces with a total charge of 1.
struct Way {
    std::array<float, 2> from{-0.4f, -0.1f};
    std::array<float, 2> to{0.35f, 0.2f};
    double seconds = 0;
    double age = 0;
    int pieces = 1;

    Beam beam() const {
        Beam beam;
        for (int i = 0; i <= pieces; ++i) {
            const float part = static_cast<float>(i) / static_cast<float>(pieces);
            beam.push_back({std::lerp(from[0], to[0], part), std::lerp(from[1], to[1], part),
                            1.0f / static_cast<float>(pieces),
                            static_cast<float>(age + seconds * (1.0 - static_cast<double>(part)))});
        }
        return beam;
    }
};

// As for points in tests/looks/phosphor_gl_test.cpp.
double stated_energy(double width) {
    const double px = width * extent.height / 512.0;
    return 0.01 * px * px * std::numbers::pi * (1.0 / 28.0 + 0.3 / 8.0);
}
}  // namespace

TEST_CASE("a segment has the energy of its charge, for any width, length and direction") {
    Tube tube({}, extent);
    for (const double width : {2.0, 16.0})
        for (const double turn : {0.0, 0.06, 0.125})
            for (const float half : {0.0f, 0.01f, 0.5f}) {
                CAPTURE(width);
                CAPTURE(turn);
                CAPTURE(half);
                const auto angle = static_cast<float>(2 * std::numbers::pi * turn);
                const float x = half * std::cos(angle);
                const float y = half * std::sin(angle);
                tube.restart(as_segments({{"beam_width", Value(width)}}));
                tube.draw(Way{.from = {-x, -y}, .to = {x, y}}.beam());
                CHECK(std::abs(tube.sum("segments") / stated_energy(width) - 1) < 0.001);
            }
}

TEST_CASE("a segment in pieces equals one segment") {
    Tube tube({}, extent);
    for (const double tube_item : {0.0, 9.0}) {
        const auto drawn = [&](int pieces) {
            tube.restart(as_segments({{"tube", Value(tube_item)}, {"decay", Value(0.5)}}));
            tube.draw(Way{.seconds = 0.004, .age = 0.001, .pieces = pieces}.beam());
            return tube.target("segments");
        };
        const Picture whole = drawn(1);
        const float peak = *std::max_element(whole.pixels.begin(), whole.pixels.end());
        for (const int pieces : {2, 16}) {
            CAPTURE(pieces);
            const Picture cut = drawn(pieces);
            float apart = 0;
            for (std::size_t i = 0; i < cut.pixels.size(); ++i)
                if (i % 4 != 3 || tube_item > 0)  // the custom tube's alpha counts segments
                    apart = std::max(apart, std::abs(cut.pixels[i] - whole.pixels[i]));
            CHECK(apart < 1e-5f * peak);
        }
    }
}

TEST_CASE("light decays within a segment by its age at each position") {
    constexpr double seconds = 0.012;
    constexpr double age = 0.002;
    const Way way{.seconds = seconds, .age = age};
    Tube tube({}, extent);
    // The mean of an exponential decay along the segment.
    const auto left = [](double rate) {
        return std::exp(-rate * age) * -std::expm1(-rate * seconds) / (rate * seconds);
    };
    for (const double decay : {0.1, 0.92, 0.999}) {
        CAPTURE(decay);
        tube.restart(as_segments({{"decay", Value(decay)}}));
        tube.draw(way.beam());
        const double expected = stated_energy(16) * left(-60 * std::log(decay));
        CHECK(std::abs(tube.sum("persistence") / expected - 1) < 0.001);
    }
    // P31: the light emitted by its terms of 0.126, 2.25 and 16 ms.
    tube.restart(as_segments({{"tube", Value(9.0)}}));
    tube.draw(way.beam());
    CHECK(std::abs(tube.sum("segments", 3) / stated_energy(16) - 1) < 0.001);
    constexpr std::array<double, 3> times{0.000126, 0.00225, 0.016};
    for (std::size_t i = 0; i < 3; ++i) {
        const double given_off = tube.sum("segments", i) / stated_energy(16);
        CHECK(std::abs(given_off - (1 - left(1 / times[i]))) < 0.001);
    }
}

TEST_CASE("segments show the same light as closely spaced points") {
    for (const double item : {0.0, 6.0}) {
        CAPTURE(item);
        const Values values = as_segments({{"tube", Value(item)}, {"beam_gain", Value(0.3)}});
        Tube tube(values, extent);
        const Way way{.seconds = 0.01, .pieces = 400};
        tube.draw(way.beam());
        const Picture segments = tube.target("persistence");
        tube.restart(with(values, {{"beam_kind", Value(0.0)}}));
        tube.draw(way.beam());
        const Picture points = tube.target("persistence");
        const float peak = *std::max_element(points.pixels.begin(), points.pixels.end());
        float apart = 0;
        for (std::size_t i = 0; i < points.pixels.size(); ++i)
            apart = std::max(apart, std::abs(points.pixels[i] - segments.pixels[i]));
        CHECK(peak > 0.001f);
        CHECK(apart < 0.02f * peak);
    }
}

TEST_CASE("only the chosen beam kind is drawn, and the article draws points") {
    Tube tube(as_segments(), extent);
    CHECK(tube.target("beam").extent == Extent{1, 1});
    CHECK(tube.target("segments").extent == extent);
    tube.restart({});
    CHECK(tube.target("beam").extent == extent);
    CHECK(tube.target("segments").extent == Extent{1, 1});
    tube.restart(as_segments({{"as_written", Value(1.0)}}));
    CHECK(tube.target("beam").extent == extent);
    tube.draw(Way{.pieces = 20}.beam());
    CHECK(tube.sum("persistence") > 0.01);
}
