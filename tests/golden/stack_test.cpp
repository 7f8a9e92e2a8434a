#include "golden/golden.h"

#include <doctest/doctest.h>

namespace {
GoldenLook stack(const char* id, int frame) {
    return {.id = id, .frames = {frame}, .preset_cell = {192, 108}, .fewest_presets = 2};
}
}  // namespace

TEST_CASE("phosphor+crt: each preset matches its golden picture, and all presets differ") {
    check_presets(stack("phosphor+crt", 6));
}

TEST_CASE(
    "vector-beam+shadow-mask: each preset matches its golden picture, and all presets differ") {
    check_presets(stack("vector-beam+shadow-mask", 6));
}

TEST_CASE("crt+crt: each preset matches its golden picture, and all presets differ") {
    check_presets(stack("crt+crt", 1));
}

TEST_CASE("crt+rolling-scan: the sub-frames of each preset match its golden picture") {
    GoldenLook look = stack("crt+rolling-scan", 6);
    look.draws_subframes = true;
    look.fewest_presets = 1;
    check_presets(look);
}

TEST_CASE("composite-video+raster-beam: each preset matches its golden picture") {
    GoldenLook look = stack("composite-video+raster-beam", 2);
    look.preset_cell = {480, 360};
    look.fewest_presets = 1;
    check_presets(look);
}
