// The shadow mask as written in its article: its loss of light, and its sampling positions.
#include "looks/shadow_mask.h"
#include "model/look/color.h"

#include <cmath>

using namespace shadow_mask;

TEST_CASE("as written in the article, the borders of cells lose light without compensation") {
    const Picture white = flat_field({48, 48}, 1.0f, 1.0f, 1.0f);
    const Picture tube = drawn_look(
        "shadow-mask", white,
        with(stages_off(),
             {{"as_written", Value(1.0)}, {"mask_size", Value(12.0)}, {"vignette", Value(0.01)}}),
        "tube");
    // Sampled at pixel centres: 4 across a stripe, 12 along a cell, each with 1 - b v^2.
    const auto sampled = [](int count) {
        double sum = 0.0;
        for (int i = 0; i < count; ++i)
            sum += 1.0 - 0.8 * std::pow((2.0 * i + 1.0) / count - 1.0, 2.0);
        return sum / count;
    };
    const double vignette = 0.97;  // of the exponent 0.01, approximately
    const double expected = sampled(4) * sampled(12) * vignette;
    CHECK(std::abs(mean_of(tube, 1, 0, 0, {48, 48}) - expected) < 0.03);
    CHECK(std::abs(std::pow(1.0 - 0.8 / 3.0, 2.0) - 0.538) < 1e-3);
    CHECK(std::abs(sampled(4) * sampled(12) - 0.538) < 0.02);
}

TEST_CASE("as written in the article, cells are sampled at their corners, under its vignette") {
    Picture ramp = flat_field({24, 48}, 0.0f, 0.0f, 0.0f);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 24; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                ramp.pixels[ramp.index(x, y) + c] = (48.0f - static_cast<float>(y) - 0.5f) / 48.0f;
    const Picture tube = drawn_look(
        "shadow-mask", ramp,
        with(stages_off(),
             {{"as_written", Value(1.0)}, {"mask_size", Value(12.0)}, {"mask_border", Value(0.0)}}),
        "tube");
    for (const int x : {5, 17})  // green stripes of both columns
        for (const int y : {13, 20, 26, 33}) {
            const double up = (48 - y - 0.5) / 12.0;  // cells
            const double light = std::floor(up + (x == 17 ? 0.5 : 0.0)) / 4.0;
            const double u = (x + 0.5) / 12.0 - 1.0;
            const double v = (y + 0.5) / 24.0 - 1.0;
            const double vignette = std::pow((1.0 - u * u) * (1.0 - v * v), 0.4);
            CHECK(std::abs(number(tube, x, y) - 3.0 * srgb_encode(light) * vignette) < 1e-4);
        }
}
