// Lines and dots of light from formulas are found, and their profiles follow the formulas.
#include "model/photo/beam_places.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

namespace {
constexpr Extent extent{320, 240};
constexpr double sigma = 3.0;  // px
constexpr double reach = 20.0;

double gaussian(double distance) {
    return std::exp(-0.5 * distance * distance / (sigma * sigma));
}

// Grey display values of light ^ (1 / 2.2), with the light at a position.
Picture photo_of(const std::function<double(glm::dvec2)>& light) {
    Picture photo{extent, 3, Encoding::display, {}};
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x) {
            const double value = std::pow(std::min(light(glm::dvec2(x, y) + 0.5), 1.0), 1.0 / 2.2);
            photo.pixels.insert(photo.pixels.end(), 3, static_cast<float>(value));
        }
    return photo;
}

const glm::dvec2 on_line(160.0, 80.0);
const glm::dvec2 along = glm::normalize(glm::dvec2(4.0, 1.0));
const glm::dvec2 dot_middle(200.3, 180.6);

double line_light(glm::dvec2 at) {
    const glm::dvec2 from = at - on_line;
    return gaussian(along.x * from.y - along.y * from.x);
}

double dot_light(glm::dvec2 at) {
    return gaussian(glm::distance(at, dot_middle));
}

BeamPlaces places_in(const Picture& photo) {
    return find_beam_places(photo, light_of_photo(photo, 2.2), corners_of(extent), reach);
}

void check_profile(const Picture& photo, const BeamPlace& place, double scale) {
    const BeamProfile profile = beam_profile(light_of_photo(photo, 2.2), place, reach);
    CHECK(profile.light.size() == BeamProfile::pieces);
    const std::vector<double> mean = profile.mean();
    double worst = 0.0;
    for (std::size_t i = 0; i < mean.size(); ++i) {
        const double distance = reach * static_cast<double>(i) / (BeamProfile::values - 1);
        worst = std::max(worst, std::abs(mean[i] - 0.1 - scale * gaussian(distance)));
    }
    CHECK(worst < 0.02 * scale);  // linear interpolation
}
}  // namespace

TEST_CASE("a line and a dot are found, and their profiles are those of the formula") {
    const Picture photo =
        photo_of([](glm::dvec2 at) { return 0.1 + 0.4 * line_light(at) + 0.5 * dot_light(at); });
    const BeamPlaces places = places_in(photo);
    REQUIRE(places.line);
    REQUIRE(places.dot);
    CHECK(!places.are_overexposed);
    const glm::dvec2 from = places.line->at - on_line;
    CHECK(std::abs(along.x * from.y - along.y * from.x) < 0.5);
    CHECK(std::abs(glm::dot(places.line->along, along)) > 0.999);
    CHECK(glm::distance(places.dot->at, dot_middle) < 1.0);
    check_profile(photo, *places.line, 0.4);
    check_profile(photo, *places.dot, 0.5);
}

TEST_CASE("crossing lines, curves and overexposed light are not used") {
    const BeamPlaces even = places_in(photo_of([](glm::dvec2) { return 0.3; }));
    CHECK(!even.line);
    CHECK(!even.dot);
    const BeamPlaces grid = places_in(photo_of([](glm::dvec2 at) {
        return 0.4 * gaussian(std::remainder(at.x, 22.0)) +
               0.4 * gaussian(std::remainder(at.y, 22.0));
    }));
    CHECK(!grid.line);
    const BeamPlaces circle = places_in(photo_of([](glm::dvec2 at) {
        return 0.5 * gaussian(glm::distance(at, glm::dvec2(160.0, 120.0)) - 30.0);
    }));
    CHECK(!circle.line);
    CHECK(!circle.dot);
    const BeamPlaces bright =
        places_in(photo_of([](glm::dvec2 at) { return 2.0 * line_light(at); }));
    CHECK(!bright.line);
    CHECK(bright.are_overexposed);
}

TEST_CASE("a blur adds its variance to that of a line") {
    const Picture photo = photo_of([](glm::dvec2 at) { return 0.5 * line_light(at); });
    const LightMap soft = blurred(light_of_photo(photo, 2.2), 4.0);
    const std::vector<double> profile = beam_profile(soft, {on_line, along}, reach).mean();
    const double expected = std::hypot(sigma, 4.0);
    CHECK(profile[0] / (0.5 * sigma / expected) == doctest::Approx(1.0).epsilon(0.01));
    const std::size_t third = (BeamProfile::values - 1) / 3;
    const double distance = reach * static_cast<double>(third) / (BeamProfile::values - 1);
    CHECK(profile[third] / profile[0] ==
          doctest::Approx(std::exp(-0.5 * std::pow(distance / expected, 2))).epsilon(0.02));
}
