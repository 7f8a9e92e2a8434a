#include "model/look/orbit.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
using Point = std::array<double, 3>;

Point moved(const Matrix& matrix, const Point& point) {
    Point result{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            result[row] += matrix[column * 4 + row] * point[column];
    return result;
}

bool is_near(const Point& a, const Point& b, double tolerance = 1e-9) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) <= tolerance;
}

const Matrix nothing{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Look look_with_orbit() {
    Look look;
    look.passes.resize(2);
    look.parameters = orbit_parameters({0, 1}, {1});
    return look;
}
}  // namespace

TEST_CASE("a default orbit is the identity") {
    CHECK(view_matrix({}) == nothing);
    CHECK(camera_matrix({}) == nothing);
}

TEST_CASE("the object rotates about x, then y, then z, right-handed") {
    CHECK(is_near(moved(view_matrix({.turn_degrees = {90, 0, 0}}), {0, 1, 0}), {0, 0, 1}));
    CHECK(is_near(moved(view_matrix({.turn_degrees = {0, 90, 0}}), {0, 0, 1}), {1, 0, 0}));
    CHECK(is_near(moved(view_matrix({.turn_degrees = {0, 0, 90}}), {1, 0, 0}), {0, 1, 0}));
    // x rotates y to z, y rotates z to x, z rotates x to y
    CHECK(is_near(moved(view_matrix({.turn_degrees = {90, 90, 90}}), {0, 1, 0}), {0, 1, 0}));
}

TEST_CASE("the camera moves by azimuth, elevation and distance") {
    const Point resting{0, 0, 1};
    CHECK(is_near(moved(camera_matrix({.azimuth_degrees = 90}), resting), {1, 0, 0}));
    CHECK(is_near(moved(camera_matrix({.elevation_degrees = 90}), resting), {0, 1, 0}));
    CHECK(is_near(moved(camera_matrix({.distance = 2.5}), resting), {0, 0, 2.5}));
    // Elevation first, then azimuth: sin and cos of 30 degrees.
    CHECK(is_near(moved(camera_matrix({.azimuth_degrees = 90, .elevation_degrees = 30}), resting),
                  {std::sqrt(3.0) / 2.0, 0.5, 0}));
}

TEST_CASE("the near side of the object follows the mouse, at any camera position") {
    for (const Orbit& start : {Orbit{}, Orbit{.turn_degrees = {20, -70, 130}},
                               Orbit{.azimuth_degrees = 120, .elevation_degrees = 40}}) {
        const Matrix camera = camera_matrix(start);
        // The object's point that is nearest to the camera.
        const Point near_side = moved(camera, {0, 0, 1});
        const Matrix now = view_matrix(start);
        Point own{};  // the inverse of a rotation is its transpose
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column)
                own[row] += now[row * 4 + column] * near_side[column];
        const double angle = std::acos(-1.0) / 18.0;  // 10 degrees
        const Orbit right = with_object_turned(start, 10, 0);
        CHECK(is_near(moved(view_matrix(right), own),
                      moved(camera, {std::sin(angle), 0, std::cos(angle)}), 1e-3));
        const Orbit up = with_object_turned(start, 0, 10);
        CHECK(is_near(moved(view_matrix(up), own),
                      moved(camera, {0, std::sin(angle), std::cos(angle)}), 1e-3));
    }
}

TEST_CASE("the camera moves against the mouse; its elevation and distance are clamped") {
    CHECK(with_camera_moved({}, 10, 0).azimuth_degrees == -10);
    CHECK(with_camera_moved({.azimuth_degrees = -175}, 10, 0).azimuth_degrees == 175);
    CHECK(with_camera_moved({}, 0, -20).elevation_degrees == 20);
    CHECK(with_camera_moved({.elevation_degrees = 85}, 0, -20).elevation_degrees == 90);
    CHECK(with_distance_scaled({.distance = 2}, 0.5).distance == 1);
    CHECK(with_distance_scaled({}, 1e-9).distance == 0.1);
    CHECK(with_distance_scaled({}, 1e9).distance == 10);
}

TEST_CASE("an orbit is read from the parameters of a pass and written back to them") {
    const Look look = look_with_orbit();
    CHECK(orbit_of(look, {}, 1) == Orbit{});
    const Orbit orbit{{10, 20, 30}, 40, 50, 2};
    const Values values =
        with_orbits_changed(look, {{"other", 7.0}}, [&](const Orbit&) { return orbit; });
    CHECK(orbit_of(look, values, 1) == orbit);
    CHECK(orbit_of(look, values, 0) == Orbit{.turn_degrees = {10, 20, 30}});  // without u_camera
    CHECK(values.at("other") == Value(7.0));
    CHECK(orbit_of(look, {{"orbit_elevation", 300.0}}, 1).elevation_degrees == 90);
}

TEST_CASE("a look without u_camera has no camera parameters") {
    CHECK(orbit_parameters({0}, {}).size() == 1);
    CHECK(orbit_parameters({}, {0}).size() == 3);
    CHECK(orbit_parameters({}, {}).empty());
}

TEST_CASE("each orbit of a stack changes from its own value") {
    Look look = look_with_orbit();
    for (Parameter& parameter : look.parameters)
        parameter.name = "caffeine/" + parameter.name;
    for (Parameter parameter : orbit_parameters({2}, {2})) {
        parameter.name = "caffeine#2/" + parameter.name;
        look.parameters.push_back(parameter);
    }
    const Values values =
        with_orbits_changed(look, {{"caffeine#2/orbit_azimuth", 30.0}},
                            [](const Orbit& orbit) { return with_camera_moved(orbit, -10, 0); });
    CHECK(values.at("caffeine/orbit_azimuth") == Value(10.0));
    CHECK(values.at("caffeine#2/orbit_azimuth") == Value(40.0));
}
