#include "golden/golden.h"

#include <doctest/doctest.h>

namespace {
const GoldenLook raster_beam{
    .id = "raster-beam",
    .frames = {1, 2},
    .cell = {160, 120},
    .preset_cell = {320, 240},
    .always = {{"dither", "false"}, {"screen_width", "20"}, {"overscan", "0.5,0.5"}},
    .companions = {{"dither", {{"dither", "true"}}},
                   {"mask_pitch", {{"mask_strength", "1"}}},
                   {"panel", {{"mask_strength", "1"}}}},
    .source = "pattern:harbour",
};
}  // namespace

TEST_CASE(
    "raster-beam: ends of each parameter match golden pictures, and one changes the picture") {
    check_parameters(raster_beam);
}

TEST_CASE("raster-beam: each preset matches its golden picture, and all presets differ") {
    check_presets(raster_beam);
}
