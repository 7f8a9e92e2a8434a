#include "signals/patterns/patterns.h"
#include "signals/patterns/solids.h"
#include "signals/patterns/tiled_noise.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace {
Picture pattern(const std::string& text) {
    const auto made = make_pattern(text);
    REQUIRE(made.has_value());
    return *made;
}

double mean_of(const Picture& picture) {
    double sum = 0.0;
    for (const float number : picture.pixels)
        sum += number;
    return sum / static_cast<double>(picture.pixels.size());
}
}  // namespace

TEST_CASE("the Bayer matrix matches the published one") {
    const Picture matrix = pattern("bayer");
    constexpr std::array rows{std::array{0, 32, 8, 40, 2, 34, 10, 42},
                              std::array{48, 16, 56, 24, 50, 18, 58, 26}};
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 8; ++x)
            CHECK(std::lround(matrix.pixels[matrix.index(x, y)] * 255.0 / 4.0) ==
                  rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]);
}

TEST_CASE("noise has the mean and variance of a uniform distribution, independent per channel") {
    const Picture noise = pattern("noise");
    CHECK(noise.channels == 4);
    CHECK(mean_of(noise) == doctest::Approx(0.5).epsilon(0.01));
    double spread = 0.0;
    double together = 0.0;
    for (std::size_t i = 0; i + 1 < noise.pixels.size(); i += 4) {
        spread += (noise.pixels[i] - 0.5) * (noise.pixels[i] - 0.5);
        together += (noise.pixels[i] - 0.5) * (noise.pixels[i + 1] - 0.5);
    }
    const double texels = static_cast<double>(noise.pixels.size()) / 4.0;
    CHECK(spread / texels == doctest::Approx(1.0 / 12.0).epsilon(0.02));  // uniform distribution
    CHECK(std::abs(together / texels) < 0.002);
}

TEST_CASE("tiled noise is continuous at its edges") {
    for (const double y : {0.1, 0.37, 0.8}) {
        CHECK(tiled_noise({0.0, y, 0.2}, 4, 1) ==
              doctest::Approx(tiled_noise({1.0, y, 0.2}, 4, 1)).epsilon(1e-9));
        CHECK(tiled_noise({y, 1e-7, 0.2}, 4, 1) ==
              doctest::Approx(tiled_noise({y, 1.0 - 1e-7, 0.2}, 4, 1)).epsilon(1e-5));
    }
    CHECK(tiled_noise({0.3, 0.3, 0.3}, 4, 1) != tiled_noise({0.3, 0.3, 0.3}, 4, 2));
}

TEST_CASE("solid patterns have rows of faces or slices, and an unknown name is an error") {
    const auto sky = make_solid("sky");
    REQUIRE(sky.has_value());
    CHECK(sky->extent.height == 6 * sky->extent.width);
    const auto volume = make_solid("grey-volume");
    REQUIRE(volume.has_value());
    CHECK(volume->extent == Extent{32, 32 * 32});
    CHECK(volume->pixels[0] == volume->pixels[1]);
    CHECK(make_solid("noise-volume")->pixels[0] != make_solid("noise-volume")->pixels[1]);
    CHECK(make_solid("ball").error().front().message ==
          "unknown cube or volume 'ball'; use sky, grey-volume or noise-volume");
}
