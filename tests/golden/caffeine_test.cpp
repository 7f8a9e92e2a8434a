#include "golden/golden.h"

#include <doctest/doctest.h>

namespace {
const GoldenLook caffeine{
    .id = "caffeine",
    .frames = {4},
    .cell = {96, 54},
    .preset_cell = {96, 54},
    .always = {{"dither", "false"}, {"samples_per_frame", "2"}},
    .companions = {{"article_gamma", {{"as_written", "true"}}},
                   {"white", {{"tone_map", "1"}, {"exposure", "3"}}}},
    .ends = {{"orbit_turn", {"0,-70,0", "60,0,30"}}},  // half turns about all three axes cancel
    .fewest_presets = 5,
};
}  // namespace

TEST_CASE("caffeine: ends of each parameter match golden pictures, and one changes the picture") {
    check_parameters(caffeine);
}

TEST_CASE("caffeine: each preset matches its golden picture, and all presets differ") {
    check_presets(caffeine);
}
