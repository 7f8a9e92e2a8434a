#include "signals/drawing/scene.h"

#include "signals/drawing/shapes.h"
#include "signals/drawing/stroke_font.h"
#include "signals/signal_making.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace {
constexpr double scene_rate = 4096.0 * 60.0;

SceneItem line(ScenePoint from, ScenePoint to) {
    return {.paths = {{{from, to}}}};
}

std::unique_ptr<Signal> signal_of(BeamScene scene) {
    auto made = make_scene_signal(std::make_shared<const BeamScene>(std::move(scene)), scene_rate);
    REQUIRE(made.has_value());
    return std::move(*made);
}

Beam traced(const Signal& signal, double from, double to) {
    Beam beam;
    signal.trace({from, to}, beam);
    return beam;
}

double length_of(const std::vector<ScenePath>& paths) {
    double sum = 0.0;
    for (const ScenePath& path : paths)
        for (std::size_t i = 1; i < path.points.size(); ++i)
            sum += std::hypot(path.points[i].x - path.points[i - 1].x,
                              path.points[i].y - path.points[i - 1].y);
    return sum;
}
}  // namespace

TEST_CASE("a line is drawn at the beam speed with full current, once per refresh") {
    const auto signal = signal_of({.items = {line({-0.5, 0.25}, {0.5, 0.25})},
                                   .beam_speed = 200.0,
                                   .move_speed = 1000.0,
                                   .refresh = 50.0});
    // One half screen at 200 per second takes 5 ms; the charge is 4096 * 60 per second.
    const double expected = 0.005 * scene_rate;
    CHECK(std::abs(charge_of(traced(*signal, 0.0, 0.02)) / expected - 1.0) < 1e-5);
    CHECK(std::abs(charge_of(traced(*signal, 0.0, 0.1)) / expected - 5.0) < 1e-4);
    const Beam half = traced(*signal, 0.0, 0.0025);
    CHECK(std::abs(half.back().x) < 1e-3f);
    CHECK(half.back().y == 0.25f);
    for (const BeamPoint& point : traced(*signal, 0.0051, 0.0199))
        CHECK(point.intensity == 0.0f);
}

TEST_CASE("adjoining time spans give the same points as one span") {
    BeamScene scene{.items = {line({-0.3, 0.1}, {0.7, 0.2}), {.paths = polygon_paths(0.4, 5, 2)}}};
    scene.items[1].spin = {10.0, 20.0, 30.0};
    scene.items[1].dwell_seconds = 1e-4;
    const auto signal = signal_of(scene);
    const Beam whole = traced(*signal, 0.0, 0.25);
    Beam parts;
    for (int i = 0; i < 25; ++i) {
        const double end = (i + 1) * 0.01;
        for (BeamPoint point : traced(*signal, i * 0.01, end))
            parts.push_back(point);
    }
    REQUIRE(parts.size() == whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i)
        CHECK((parts[i].x == whole[i].x && parts[i].y == whole[i].y &&
               parts[i].intensity == whole[i].intensity));
}

TEST_CASE("moves between paths are blanked, or lit if moves are visible") {
    BeamScene scene{.items = {line({-0.5, 0.0}, {-0.4, 0.0}), line({0.4, 0.0}, {0.5, 0.0})},
                    .beam_speed = 100.0,
                    .move_speed = 100.0,
                    .refresh = 0.0};
    // 0.1 + 0.1 are drawn; 0.8 and 1 back are moves.
    CHECK(std::abs(charge_of(traced(*signal_of(scene), 0.0, 0.02)) / (0.002 * scene_rate) - 1.0) <
          1e-4);
    scene.move_current = 0.5;
    CHECK(std::abs(charge_of(traced(*signal_of(scene), 0.0, 0.02)) / (0.011 * scene_rate) - 1.0) <
          1e-4);
}

TEST_CASE("a corner with dwell gets the light of its dwell time") {
    BeamScene scene{.items = {line({0.0, 0.0}, {0.1, 0.0})}, .beam_speed = 100.0};
    const double without = charge_of(traced(*signal_of(scene), 0.0, 1.0 / 60.0));
    scene.items[0].dwell_seconds = 0.002;
    const double with = charge_of(traced(*signal_of(scene), 0.0, 1.0 / 60.0));
    CHECK(std::abs((with - without) / (2.0 * 0.002 * scene_rate) - 1.0) < 1e-4);
}

TEST_CASE("a rotated, spun or perspective item has the expected position") {
    SceneItem item = line({0.5, 0.0}, {0.5, 0.0001});
    item.at = {0.1, 0.2};
    item.turn = {0.0, 0.0, 90.0};
    CHECK(std::abs(traced(*signal_of({.items = {item}}), 0.0, 0.01).front().y - 0.7f) < 1e-3f);
    item.turn = {0.0, 90.0, 0.0};  // about y: right moves away from the eye
    CHECK(std::abs(traced(*signal_of({.items = {item}}), 0.0, 0.01).front().x - 0.1f) < 1e-3f);
    item.turn = {};
    item.spin = {0.0, 0.0, 180.0};  // half a turn per second, after one second
    const Beam later = traced(*signal_of({.items = {item}}), 1.0, 1.005);
    CHECK(std::abs(later.front().x + 0.4f) < 1e-3f);
    SceneItem near = line({0.2, 0.0, 1.0}, {0.2, 0.0001, 1.0});
    near.perspective = 2.0;  // 1 of 2 towards the eye: twice as large
    CHECK(std::abs(traced(*signal_of({.items = {near}}), 0.0, 0.01).front().x - 0.4f) < 1e-3f);
}

TEST_CASE("shapes have the lengths of their geometry") {
    const double pi = std::acos(-1.0);
    CHECK(std::abs(length_of({arc_path(0.5, 0.0, 360.0)}) - pi) < 1e-3);
    CHECK(std::abs(length_of({arc_path(0.5, 30.0, -60.0)}) - pi / 4.0) < 1e-3);
    CHECK(std::abs(length_of(polygon_paths(1.0, 6, 1)) - 6.0) < 1e-9);
    CHECK(polygon_paths(1.0, 6, 2).size() == 2);  // a hexagram has two triangles
    CHECK(std::abs(length_of(polygon_paths(1.0, 6, 2)) - 6.0 * std::sqrt(3.0)) < 1e-9);
    CHECK(std::abs(length_of(grid_paths(2.0, 1.0, 4, 2)) - (5 * 1.0 + 3 * 2.0)) < 1e-9);
    // A cube has 12 edges; each is drawn once.
    std::vector<ScenePoint> corners;
    std::vector<std::array<std::size_t, 2>> edges;
    for (std::size_t i = 0; i < 8; ++i) {
        corners.push_back({i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0});
        for (const std::size_t bit : {1u, 2u, 4u})
            if ((i & bit) == 0)
                edges.push_back({i, i | bit});
    }
    std::size_t drawn = 0;
    for (const ScenePath& path : edge_paths(corners, edges))
        drawn += path.points.size() - 1;
    CHECK(drawn == 12);
}

TEST_CASE("the current of a raster is the light of its picture") {
    const Picture picture{{2, 2}, 1, Encoding::linear, {0.0f, 1.0f, 0.5f, 0.25f}};
    const auto paths = raster_paths(picture, 1.0, 2);
    REQUIRE(paths.size() == 2);
    REQUIRE(paths[0].points.size() == 3);
    CHECK(paths[0].points[0].y == 0.25);
    CHECK(paths[0].points[1].current == 0.0);
    CHECK(paths[0].points[2].current == 1.0);
    CHECK(paths[1].points[1].current == 0.5);
    CHECK(paths[1].points[2].current == 0.25);
}

TEST_CASE("every printable character has a glyph, and all glyphs differ") {
    std::set<std::vector<double>> points;
    for (char character = '!'; character <= '_'; ++character) {
        CAPTURE(character);
        std::vector<double> numbers;
        const auto paths = text_paths(std::string(1, character), 6.0, TextAlign::left);
        for (const ScenePath& path : paths)
            for (const ScenePoint& point : path.points) {
                numbers.push_back(point.x);
                numbers.push_back(point.y);
                CHECK(std::abs(point.y) <= 3.0);
            }
        CHECK(length_of(paths) > 0.5);
        CHECK(points.insert(numbers).second);
    }
    CHECK(text_paths("a", 1.0, TextAlign::left).size() ==
          text_paths("A", 1.0, TextAlign::left).size());
    CHECK(text_paths("\xE4\xB8\xAD", 1.0, TextAlign::left).size() == 1);  // 中: one box
    CHECK(text_paths("A\nA", 1.0, TextAlign::left).size() == 4);
}

TEST_CASE("a scene that draws nothing or too much is an error") {
    const auto refused = [](BeamScene scene) {
        return !make_scene_signal(std::make_shared<const BeamScene>(std::move(scene)), scene_rate)
                    .has_value();
    };
    CHECK(refused({}));
    CHECK(refused({.items = {line({0.5, 0.5}, {0.5, 0.5})}}));
    SceneItem dark = line({0.0, 0.0}, {1.0, 0.0});
    dark.current = 0.0;
    CHECK(refused({.items = {dark}}));
    SceneItem huge;
    huge.paths = {{std::vector<ScenePoint>(max_scene_points + 1)}};
    CHECK(refused({.items = {huge}}));
}
