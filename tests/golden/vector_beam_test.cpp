#include "golden/golden.h"

#include <doctest/doctest.h>

namespace {
const GoldenLook vector_beam{
    .id = "vector-beam",
    .frames = {1, 6},
    .always = {{"dither", "false"},     // noise would hide small changes and increase file sizes
               {"spot_sigma", "2.4"}},  // as in a larger picture: each pixel is read once
    .companions = {{"dwell", {{"dwell_speed", "1000"}}},
                   {"dwell_speed", {{"dwell", "4"}}},
                   {"growth_power", {{"intensity", "0.3"}, {"spot_growth", "1.5"}}},
                   // The shortcut is visible if a frame's segments are short and decay quickly.
                   {"decay_by_place", {{"decay_time", "0.02"}, {"spot_sigma", "6"}}},
                   {"quad_sigmas", {{"exposure", "16"}}},
                   {"white", {{"tone_map", "Extended Reinhard"}}}},
    .signal = "lissajous:x=5,y=4,speed=0.05,points=320",  // enough for so small a picture
};
}  // namespace

TEST_CASE(
    "vector-beam: ends of each parameter match golden pictures, and one changes the picture") {
    check_parameters(vector_beam);
}

TEST_CASE("vector-beam: each preset matches its golden picture, and all presets differ") {
    check_presets(vector_beam);
}
