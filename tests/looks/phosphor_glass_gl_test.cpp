// Phosphor's glass compared with closed forms: aberration, graticule, corners, room light, dither.
#include "about.h"
#include "looks/glsl_function.h"
#include "looks/tube.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
const double light = 3.75 / 4.75;  // plain_glass() shows flood() as Reinhard of 2.5 x 1.5

/// The horizontal centroid of a channel's light, in px from the left.
double middle_of(const Picture& picture, std::size_t channel) {
    double sum = 0.0;
    double moment = 0.0;
    for (int y = 0; y < picture.extent.height; ++y)
        for (int x = 0; x < picture.extent.width; ++x) {
            const auto value = static_cast<double>(picture.pixels[picture.index(x, y) + channel]);
            sum += value;
            moment += value * (x + 0.5);
        }
    return moment / sum;
}

Value color(double red, double green, double blue) {
    return Value(std::vector<double>{red, green, blue});
}
}  // namespace

TEST_CASE("aberration shifts red to the left and blue to the right, in px of the picture") {
    Tube tube(with(plain_glass(), {{"beam_width", Value(8.0)},
                                   {"aberration", Value(3.0)},
                                   {"tone_map", Value(0.0)},
                                   {"exposure", Value(0.1)}}),
              {200, 100});
    tube.draw({{0.0f, 0.0f, 1.0f, 0.0f}});
    const Picture shown = tube.target("composite");
    CHECK(is_near(middle_of(shown, 0), 97.0, 0.01));
    CHECK(is_near(middle_of(shown, 1), 100.0, 0.01));
    CHECK(is_near(middle_of(shown, 2), 103.0, 0.01));
}

TEST_CASE("the glass reflects the room light, less in dark corners") {
    Tube tube(
        with(plain_glass(), {{"ambient_glass", color(0.1, 0.2, 0.3)}, {"vignette", Value(0.8)}}));
    tube.draw({});
    const double place = 0.5 / 64.0;  // of the pixel next to the centre
    CHECK(is_near(tube.at("composite", 64, 64, 2), 0.3 * (1.0 - 0.8 * place * place), 1e-6));
    const double edge = 127.0 / 128.0;
    CHECK(is_near(tube.at("composite", 127, 127, 1), 0.2 * (1.0 - 0.8 * edge * edge), 1e-6));
}

TEST_CASE("the lines of the graticule add light or hide it") {
    Tube tube({}, {101, 51});
    const auto shown = [&tube](bool is_lit, const Values& values, int x, int y) {
        tube.restart(
            with(with(plain_glass(), {{"graticule", Value(0.5)},
                                      {"graticule_color", color(1.0, 0.8, 0.4)},
                                      {"graticule_divisions", Value(std::vector<double>{10, 8})}}),
                 values));
        tube.draw(is_lit ? tube.flood() : Beam{});
        return tube.at("composite", x, y, 1);
    };
    CHECK(is_near(shown(false, {}, 50, 25), 0.5 * 0.8, 1e-6));  // where the axes cross
    CHECK(is_near(shown(true, {}, 50, 25), light + 0.5 * 0.8 * (1.0 - light), 1e-5));
    CHECK(is_near(shown(true, {{"graticule_lines", Value(1.0)}}, 50, 25), light * 0.5, 1e-5));
    // Two lines from the centre, 1 px wide, at 0.6 of the axes' strength; the pixel is next to the
    // line.
    const double wide = 2.0 * 101.0 / 10.0;
    const double covered = 1.0 - std::abs(wide - 20.0);
    CHECK(is_near(shown(false, {}, 70, 22), 0.5 * 0.8 * 0.6 * covered, 1e-4));
    // With round circles the boxes are squares of an eighth of the height.
    const double square = 3.0 * 51.0 / 8.0;
    CHECK(is_near(shown(false, {{"fit", Value(1.0)}}, 69, 22),
                  0.5 * 0.8 * 0.6 * (1.0 - std::abs(square - 19.0)), 1e-4));
}

TEST_CASE("the graticule has lines, axes, ticks and a frame") {
    // x, y: divisions from the centre; z, w: total divisions. A division is 100 px, a line 2 px.
    constexpr const char* body =
        "#include \"graticule.glsl\"\n"
        "vec4 f(vec4 x) { return vec4(graticule_coverage(x.xy, x.zw, vec2(100.0), 2.0)); }\n";
    struct Case {
        Vec4 place;
        double expected;
    };
    const std::vector<Case> cases{
        {{1.0, 0.35, 10, 10}, 0.6},   // a line
        {{1.35, 0.35, 10, 10}, 0.0},  // between lines
        {{1.35, 0.0, 10, 10}, 1.0},   // the horizontal axis
        {{0.0, 2.35, 10, 10}, 1.0},   // the vertical axis
        {{1.2, 0.09, 10, 10}, 1.0},   // a tick every fifth of a division, a tenth to each side
        {{1.2, 0.12, 10, 10}, 0.0},   //
        {{0.09, 2.4, 10, 10}, 1.0},   //
        {{5.0, 0.35, 10, 10}, 0.6},   // the frame
        {{6.0, 0.35, 10, 10}, 0.0},   // outside the frame
        {{0.35, 5.3, 10, 10}, 0.0},   //
        {{1.0, 0.35, 5, 10}, 0.0},    // five divisions: the lines are shifted by half a division
        {{1.5, 0.35, 5, 10}, 0.6},    //
        {{0.0, 0.35, 5, 10}, 1.0},    // but the axis is not
    };
    std::vector<Vec4> places;
    for (const Case& one : cases)
        places.push_back(one.place);
    const auto found = run_glsl(body, places);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        CAPTURE(i);
        CHECK(is_near(found[i][0], cases[i].expected, 1e-4));
    }
}

TEST_CASE("rounded corners cut (4 - pi) r^2 off the glass") {
    for (const Extent extent : {Extent{128, 128}, Extent{192, 128}}) {
        CAPTURE(extent.width);
        const double area = 4.0 * extent.width / extent.height;  // in half heights
        Tube tube(plain_glass(), extent);
        tube.draw(tube.flood());
        const double whole = tube.sum("composite");
        tube.restart(with(plain_glass(), {{"corner_radius", Value(0.5)}}));
        tube.draw(tube.flood());
        const double cut = (4.0 - std::acos(-1.0)) * 0.25;
        CHECK(is_near(tube.sum("composite") / whole, 1.0 - cut / area, 3e-4));
        CHECK(tube.at("composite", 0, 0) == 0.0);
        CHECK(is_near(tube.at("composite", extent.width / 2, 0), light, 1e-5));
    }
}

TEST_CASE("dither is noise of half an 8-bit step in both directions, and keeps the mean") {
    Tube tube(with(plain_glass(), {{"dither", Value(1.0)}}));
    tube.draw(tube.flood());
    double lowest = 0.0;
    double highest = 0.0;
    double mean = 0.0;
    const Picture shown = tube.target("composite");
    for (std::size_t i = 1; i < shown.pixels.size(); i += 4) {
        const double codes = 255.0 * (static_cast<double>(shown.pixels[i]) - light);
        lowest = std::min(lowest, codes);
        highest = std::max(highest, codes);
        mean += codes / (128.0 * 128.0);
    }
    CHECK(is_near(lowest, -0.5, 0.01));
    CHECK(is_near(highest, 0.5, 0.01));
    CHECK(std::abs(mean) < 4.0 / std::sqrt(12.0) / 128.0);  // four standard deviations
}
