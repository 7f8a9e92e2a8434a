#include "golden/golden.h"

#include <doctest/doctest.h>

namespace {
const GoldenLook phosphor{
    .id = "phosphor",
    .always = {{"dither", "false"}},  // noise would hide small changes and increase file sizes
    .companions = {{"tone_map_every_frame", {{"ceiling", "20"}}},
                   {"one_color", {{"fade_speed", "1,8,1"}}},  // one_color ignores it
                   {"bloom_taps", {{"bloom_kind", "Taps"}}},
                   {"time_scale", {{"tube", "P31"}}},
                   {"tail_gain", {{"tube", "P7"}}},
                   {"tube_color", {{"tube", "P7"}}},
                   {"afterglow_color", {{"tube", "P7"}, {"tube_color", "2"}}}},
    .signals = {{"beam_kind", "lissajous:x=3,y=2,points=96"}},  // few enough to be distinguishable
    .sources = {{"picture_gain", "pattern:harbour,size=160x90"},
                {"spot_size", "pattern:harbour,size=160x90"}},
    .fewest_presets = 13,
    .faster = {"article-mono"},
    .signal = "lissajous:x=3,y=2,speed=0.015,points=1024",  // enough for so small a picture
};
}  // namespace

TEST_CASE("phosphor: ends of each parameter match golden pictures, and one changes the picture") {
    check_parameters(phosphor);
}

TEST_CASE("phosphor: each preset matches its golden picture, and all presets differ") {
    check_presets(phosphor);
}
