#include "golden/golden.h"

#include <doctest/doctest.h>

namespace {
const GoldenLook rolling_scan{
    .id = "rolling-scan",
    .frames = {5, 6, 8},
    .always = {{"dither", "false"}, {"brightness", "0.4"}},
    .companions = {{"dither", {{"dither", "true"}}}},
    .draws_subframes = true,
    .source = "pattern:harbour,size=160x90",
};
}  // namespace

TEST_CASE(
    "rolling-scan: ends of each parameter match golden pictures, and one changes the picture") {
    check_parameters(rolling_scan);
}

TEST_CASE("rolling-scan: each preset matches its golden picture, and all presets differ") {
    check_presets(rolling_scan);
}
