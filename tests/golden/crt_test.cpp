#include "golden/golden.h"

#include <doctest/doctest.h>

namespace {
const GoldenLook crt{
    .id = "crt",
    .frames = {1, 16},
    .always = {{"dither", "false"}},
    .companions = {{"white", {{"tone_map", "3"}, {"exposure", "4"}}},
                   {"keep_hue", {{"exposure", "6"}}},
                   {"exposure", {{"tone_map", "1"}}},
                   {"scanline_period", {{"scanline_strength", "1"}}},
                   {"scanline_unit", {{"scanline_strength", "1"}, {"scanline_lines", "5"}}},
                   {"scanline_lines", {{"scanline_strength", "1"}, {"scanline_unit", "1"}}},
                   {"scanline_interlace",
                    {{"scanline_strength", "1"}, {"scanline_unit", "1"}, {"scanline_lines", "2"}}},
                   {"scanline_brightness", {{"scanline_strength", "1"}}}},
    .source = "pattern:glyph-rain,size=160x90",
};
}  // namespace

TEST_CASE("crt: ends of each parameter match golden pictures, and one changes the picture") {
    check_parameters(crt);
}

TEST_CASE("crt: each preset matches its golden picture, and all presets differ") {
    check_presets(crt);
}
