#include "model/photo/camera.h"

#include <doctest/doctest.h>

namespace {
constexpr Extent photo{1000, 760};
const Corners corners{glm::dvec2(90, 70), glm::dvec2(905, 60), glm::dvec2(915, 690),
                      glm::dvec2(80, 700)};

void check_near(glm::dvec2 one, glm::dvec2 other) {
    CHECK(one.x == doctest::Approx(other.x).epsilon(1e-9));
    CHECK(one.y == doctest::Approx(other.y).epsilon(1e-9));
}
}  // namespace

TEST_CASE("the screen's corners are seen where they were placed, with any lens") {
    for (const double lens : {-0.05, 0.0, 0.05}) {
        const ScreenMap map({.corners = corners, .lens = lens}, photo);
        check_near(map.photo_at({0, 0}), corners[0]);
        check_near(map.photo_at({1, 0}), corners[1]);
        check_near(map.photo_at({1, 1}), corners[2]);
        check_near(map.photo_at({0, 1}), corners[3]);
    }
}

TEST_CASE("in perspective the diagonals cross at the screen's middle") {
    const glm::dvec2 a = corners[2] - corners[0];
    const glm::dvec2 b = corners[3] - corners[1];
    const glm::dvec2 between = corners[1] - corners[0];
    const double share = (between.x * b.y - between.y * b.x) / (a.x * b.y - a.y * b.x);
    check_near(ScreenMap({.corners = corners}, photo).photo_at({0.5, 0.5}), corners[0] + share * a);
}

TEST_CASE("a lens moves a place by the cube of its distance from the photo's centre") {
    const Corners square{glm::dvec2(300, 180), glm::dvec2(700, 180), glm::dvec2(700, 580),
                         glm::dvec2(300, 580)};
    constexpr double lens = 0.08;
    const ScreenMap map({.corners = square, .lens = lens}, photo);
    const double unit = std::hypot(500.0, 380.0);
    // Undistorted, the corners are at d with d (1 + k d^2) = 200 sqrt(2) / unit.
    double corner = 200.0 * std::sqrt(2.0) / unit;
    const double seen_corner = corner;
    for (int i = 0; i < 50; ++i)
        corner = seen_corner / (1.0 + lens * corner * corner);
    const double side = corner / std::sqrt(2.0);
    check_near(map.photo_at({0.5, 0.0}), {500.0, 380.0 - unit * side * (1.0 + lens * side * side)});
}

TEST_CASE("slopes are the size of a px of the picture in the photo") {
    const Corners square{glm::dvec2(100, 100), glm::dvec2(500, 100), glm::dvec2(500, 400),
                         glm::dvec2(100, 400)};
    const glm::dmat2 slope = ScreenMap({.corners = square}, photo).slope_at({0.3, 0.6}, {200, 100});
    check_near(slope[0], {2.0, 0.0});
    check_near(slope[1], {0.0, 3.0});
}

TEST_CASE("corners that are outside, crossed, mirrored or too close are refused") {
    CHECK(check_corners(corners, photo).has_value());
    const auto refused = [](const Corners& wrong) {
        const auto checked = check_corners(wrong, photo);
        return checked ? std::string() : checked.error().front().message;
    };
    CHECK(refused({corners[0], corners[1], glm::dvec2(2000, 690), corners[3]}).find("outside") !=
          std::string::npos);
    CHECK(refused({corners[1], corners[0], corners[2], corners[3]}).find("crossed") !=
          std::string::npos);
    CHECK(refused({corners[1], corners[0], corners[3], corners[2]}).find("mirrored") !=
          std::string::npos);
    CHECK(refused({corners[0], corners[0], corners[2], corners[3]}).find("too close") !=
          std::string::npos);
}
