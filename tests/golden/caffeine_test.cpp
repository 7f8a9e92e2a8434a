#include "golden/golden.h"

#include <doctest/doctest.h>

namespace {
const GoldenLook caffeine{
    .id = "caffeine",
    .frames = {4},
    .preset_cell = {96, 54},
    .fewest_presets = 5,
};
}  // namespace

TEST_CASE("caffeine: each preset looks as it did, and no two look the same") {
    check_presets(caffeine);
}
