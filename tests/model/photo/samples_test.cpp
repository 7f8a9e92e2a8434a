#include "model/photo/samples.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace {
constexpr Extent size{480, 360};
constexpr Extent photo_size{500, 400};
const SampleLayout layout(size);

// The screen covers a part of the photo at this many photo px per px.
Camera camera_with(double scale) {
    return {.corners = {glm::dvec2(10, 20), glm::dvec2(10 + scale * size.width, 20),
                        glm::dvec2(10 + scale * size.width, 20 + scale * size.height),
                        glm::dvec2(10, 20 + scale * size.height)}};
}

ScreenLight light_of(const std::function<glm::vec3(glm::dvec2)>& color) {
    ScreenLight light;
    for (int tile = 0; tile < layout.tile_count(); ++tile)
        for (int y = 0; y < SampleLayout::stride; ++y)
            for (int x = 0; x < SampleLayout::stride; ++x)
                light.tiles.push_back(color(glm::dvec2(layout.origin(tile)) + glm::dvec2(x, y) -
                                            double{SampleLayout::margin} + 0.5));
    for (int cell = 0; cell < layout.cell_count(); ++cell)
        light.cells.push_back(color(layout.cell_centre(cell)));
    return light;
}

double luma(double r, double g, double b) {
    return 0.299 * r + 0.587 * g + 0.114 * b;
}
}  // namespace

TEST_CASE("tiles with their margins lie in the picture and do not overlap") {
    for (const Extent extent : {Extent{480, 360}, Extent{800, 600}, Extent{200, 160}}) {
        const SampleLayout tested(extent);
        for (int tile = 0; tile < tested.tile_count(); ++tile) {
            const glm::ivec2 first = tested.origin(tile) - SampleLayout::margin;
            CHECK(first.x >= 0);
            CHECK(first.y >= 0);
            CHECK(first.x + SampleLayout::stride <= extent.width);
            CHECK(first.y + SampleLayout::stride <= extent.height);
            if (tile % tested.tiles.width > 0)
                CHECK(first.x >= tested.origin(tile - 1).x + SampleLayout::side);
        }
    }
}

TEST_CASE("even light becomes the square of (vignette * colour * light) ^ (1 / gamma)") {
    Camera camera = camera_with(0.9);
    camera.vignette = 0.3;
    camera.gamma = 2.4;
    camera.colour = glm::dmat3(0.7, 0.1, 0.0, 0.0, 0.6, 0.0, 0.05, 0.0, 0.5);
    const SamplePlaces places(layout, camera, photo_size);
    const ScreenLight light = light_of([](glm::dvec2) { return glm::vec3(0.5F, 0.25F, 0.125F); });
    const SampleValues values =
        developed(blurred(light, camera, layout, places), camera, layout, places);
    const glm::dvec3 seen = camera.colour * glm::dvec3(0.5, 0.25, 0.125);
    const std::size_t last = values.points.size() - 1;
    for (const std::size_t point : {std::size_t{0}, last}) {
        const double left = 1.0 - 0.3 * static_cast<double>(places.point_radii[point]);
        const auto value = [&](double channel) { return std::pow(left * channel, 2.0 / 2.4); };
        const double expected = luma(value(seen.r), value(seen.g), value(seen.b));
        CHECK(values.points[point].x == doctest::Approx(expected).epsilon(1e-4));
        CHECK(values.points[point].z ==
              doctest::Approx((value(seen.r) - expected) / 1.402).epsilon(1e-3));
    }
}

TEST_CASE("a lens with a Gaussian blur dims a wave by exp(-2 (pi sigma / period)^2)") {
    constexpr double period = 9.0;  // px of the picture
    constexpr double scale = 0.8;
    Camera camera = camera_with(scale);
    camera.blur = 1.2;
    camera.gamma = 2.0;  // squares are light
    const SamplePlaces places(layout, camera, photo_size);
    const ScreenLight light = light_of([](glm::dvec2 at) {
        return glm::vec3(
            static_cast<float>(0.5 + 0.4 * std::cos(2.0 * std::numbers::pi * at.x / period)));
    });
    const SampleValues values =
        developed(blurred(light, camera, layout, places), camera, layout, places);
    const double sigma = camera.blur / scale;
    const double contrast = 0.4 * std::exp(-2.0 * std::pow(std::numbers::pi * sigma / period, 2));
    for (int x = 0; x < SampleLayout::side; ++x) {
        const double at = layout.origin(0).x + x + 0.5;
        CHECK(values.tiles[static_cast<std::size_t>(x)].x ==
              doctest::Approx(0.5 + contrast * std::cos(2.0 * std::numbers::pi * at / period))
                  .epsilon(0.005));
    }
}

TEST_CASE("a photo gives the squares of its pixels, and the mean light of an area") {
    Picture picture{{64, 48}, 3, Encoding::display, {}};
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            picture.pixels.insert(picture.pixels.end(), {x < 32 ? 0.2F : 0.8F, 0.5F, 0.0F});
    const Photo photo(picture);
    CHECK(photo.at({10.5, 20.5}).r == doctest::Approx(0.04));
    CHECK(photo.at({50.5, 20.5}).r == doctest::Approx(0.64));
    const glm::vec3 mean = photo.mean_light_at({32.0, 24.0}, glm::dmat2(16, 0, 0, 16), 16);
    CHECK(mean.r == doctest::Approx(0.5 * (std::pow(0.2, 2.2) + std::pow(0.8, 2.2))));
    CHECK(mean.g == doctest::Approx(std::pow(0.5, 2.2)));
}
