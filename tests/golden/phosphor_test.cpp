#include "golden/golden.h"

#include <doctest/doctest.h>

namespace {
const GoldenLook phosphor{
    .id = "phosphor",
    .always = {{"dither", "false"}},  // noise would hide small changes and swell the files
    .companions = {{"tone_map_every_frame", {{"ceiling", "20"}}},
                   {"one_color", {{"fade_speed", "1,8,1"}}},  // which it leaves out
                   {"bloom_taps", {{"bloom_kind", "Taps"}}},
                   {"time_scale", {{"tube", "P31"}}},
                   {"tail_gain", {{"tube", "P7"}}},
                   {"tube_color", {{"tube", "P7"}}},
                   {"afterglow_color", {{"tube", "P7"}, {"tube_color", "2"}}}},
    .signals = {{"beam_kind", "lissajous:x=3,y=2,points=96"}},  // few enough to be told apart
    .fewest_presets = 9,
    .faster = {"article-mono"},
    .signal = "lissajous:x=3,y=2,speed=0.015,points=1024",  // enough for so few pixels
};
}  // namespace

TEST_CASE("phosphor: each parameter's ends look as they did, and one changes the picture") {
    check_parameters(phosphor);
}

TEST_CASE("phosphor: each preset looks as it did, and no two look the same") {
    check_presets(phosphor);
}
