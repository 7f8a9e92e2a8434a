// The pyramid bloom: energy, width and shape.
#include "about.h"
#include "looks/tube.h"

#include <doctest/doctest.h>

#include <array>

namespace {
constexpr int side = 256;

Values pyramid_of(double radius, const Values& more = {}) {
    return with({{"bloom_kind", Value(1.0)},
                 {"bloom_radius", Value(radius)},
                 {"bloom_sigma", Value(1.64)},
                 {"ceiling", Value(1000.0)}},
                more);
}

struct SpotMoments {
    double energy = 0.0;
    double x = 0.0;  // px of the full picture
    double y = 0.0;
    double variance = 0.0;  // px^2 along one axis
};

SpotMoments moments_of(const Picture& picture) {
    const double step = side / static_cast<double>(picture.extent.width);
    SpotMoments found;
    double squares = 0.0;
    for (int y = 0; y < picture.extent.height; ++y)
        for (int x = 0; x < picture.extent.width; ++x) {
            const auto light = static_cast<double>(picture.pixels[picture.index(x, y) + 1]);
            const double across = (x + 0.5) * step;
            const double down = (y + 0.5) * step;
            found.energy += light * step * step;
            found.x += light * step * step * across;
            found.y += light * step * step * down;
            squares += light * step * step * (across * across + down * down);
        }
    found.x /= found.energy;
    found.y /= found.energy;
    found.variance = 0.5 * (squares / found.energy - found.x * found.x - found.y * found.y);
    return found;
}

// The largest increase along the row, from the brightest texel outwards, relative to that texel.
double worst_rise(const Picture& picture) {
    const auto light = [&picture](int x, int y) {
        return static_cast<double>(picture.pixels[picture.index(x, y) + 1]);
    };
    int row = 0;
    int column = 0;
    for (int y = 0; y < picture.extent.height; ++y)
        for (int x = 0; x < picture.extent.width; ++x)
            if (light(x, y) > light(column, row)) {
                column = x;
                row = y;
            }
    double worst = 0.0;
    for (int x = 1; x < picture.extent.width; ++x) {
        const bool is_before = x <= column;
        const double rise =
            is_before ? light(x - 1, row) - light(x, row) : light(x, row) - light(x - 1, row);
        worst = std::max(worst, rise);
    }
    return worst / light(column, row);
}
}  // namespace

TEST_CASE(
    "the pyramid keeps a spot's energy and centre and has the stated sigma, at any position") {
    Tube tube({}, {side, side});
    for (const double radius : {1.0, 3.0, 6.0, 12.0})
        for (const std::array<float, 2>& place :
             {std::array{0.0f, 0.0f}, {0.013f, -0.021f}, {-0.0391f, 0.0273f}, {0.061f, 0.0586f}}) {
            CAPTURE(radius);
            CAPTURE(place[0]);
            tube.restart(pyramid_of(radius));
            tube.draw({{place[0], place[1], 1.0f, 0.0f}});
            const SpotMoments lit = moments_of(tube.target("persistence"));
            const SpotMoments reduced = moments_of(tube.target("reduced"));
            const SpotMoments spread = moments_of(tube.target("bloom_y"));
            const double sigma = 1.64 * radius * 2.0 * side / 512.0;  // px
            CHECK(is_near(spread.energy / lit.energy, 1.0, 0.001));
            CHECK(is_near(spread.x, reduced.x, 0.01));
            CHECK(is_near(spread.y, reduced.y, 0.01));
            CHECK(is_near((spread.variance - reduced.variance) / (sigma * sigma), 1.0, 0.01));
        }
}

// Six levels down and up: sqrt((4^6 - 1) / 2) = 45.2 texels of the base level.
TEST_CASE("the pyramid has the stated sigma up to 45 texels") {
    Tube tube({}, {4 * side, 4 * side});
    for (const double radius : {9.0, 13.5}) {
        CAPTURE(radius);
        tube.restart(pyramid_of(radius));
        tube.draw({{0.0f, 0.0f, 1.0f, 0.0f}});
        const double sigma = 1.64 * radius;  // in pairs of texels, the unit of moments_of here
        const double added = moments_of(tube.target("bloom_y")).variance -
                             moments_of(tube.target("reduced")).variance;
        CHECK(is_near(added / (sigma * sigma), 1.0, 0.01));
    }
}

TEST_CASE("the pyramid has no secondary peaks") {
    Tube tube({}, {side, side});
    for (const double radius : {1.0, 2.0, 3.0, 4.5, 6.0, 9.0, 12.0}) {
        CAPTURE(radius);
        tube.restart(pyramid_of(radius));
        tube.draw({{0.0117f, 0.0f, 1.0f, 0.0f}});
        CHECK(worst_rise(tube.target("bloom_y")) < 1e-6);
    }
    tube.restart(pyramid_of(3.0, {{"as_written", Value(1.0)}, {"bloom_kind", Value(0.0)}}));
    tube.draw({{0.0117f, 0.0f, 1.0f, 0.0f}});
    CHECK(worst_rise(tube.target("bloom_y")) > 0.02);  // the article's taps do
}

TEST_CASE("the pyramid is as wide as the article's table of taps") {
    Tube tube({}, {side, side});
    const auto added = [&tube](double kind) {
        tube.restart(pyramid_of(3.0, {{"as_written", Value(1.0)}, {"bloom_kind", Value(kind)}}));
        tube.draw({{0.0f, 0.0f, 1.0f, 0.0f}});
        return moments_of(tube.target("bloom_y")).variance -
               moments_of(tube.target("persistence")).variance;
    };
    CHECK(is_near(added(1.0) / added(0.0), 1.0, 0.01));
}

TEST_CASE("light that leaves the picture does not return, at any size") {
    for (const Extent extent : {Extent{100, 76}, Extent{101, 77}, Extent{33, 251}}) {
        CAPTURE(extent.width);
        Tube tube(pyramid_of(3.0), extent);
        const auto kept = [&tube](double radius, float x) {
            tube.restart(pyramid_of(radius));
            tube.draw({{x, 0.0f, 1.0f, 0.0f}});
            return tube.sum("bloom_y") / tube.sum("reduced");
        };
        CHECK(is_near(kept(3.0, 0.0f), 1.0, 0.002));
        CHECK(kept(12.0, 1.0f) < 0.7);  // part of it spreads beyond the edge
    }
}
