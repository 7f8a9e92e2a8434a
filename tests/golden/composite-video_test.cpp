#include "golden/golden.h"

#include <doctest/doctest.h>

namespace {
const GoldenLook composite_video{
    .id = "composite-video",
    .frames = {2},
    .cell = {160, 120},
    .preset_cell = {320, 240},
    .always = {{"dither", "false"}},
    .companions = {{"dither", {{"dither", "true"}}},
                   {"ghost", {{"connection", "3"}}},
                   {"ghost_delay", {{"connection", "3"}, {"ghost", "0.5"}}},
                   {"rf_bandwidth", {{"connection", "3"}}},
                   {"delay_line", {{"standard", "1"}, {"hue", "0.5"}}}},
    .source = "pattern:harbour",
};
}  // namespace

TEST_CASE(
    "composite-video: ends of each parameter match golden pictures, and one changes the picture") {
    check_parameters(composite_video);
}

TEST_CASE("composite-video: each preset matches its golden picture, and all presets differ") {
    check_presets(composite_video);
}
