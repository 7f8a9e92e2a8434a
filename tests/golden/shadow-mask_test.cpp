#include "golden/golden.h"

#include <doctest/doctest.h>

namespace {
const GoldenLook shadow_mask{
    .id = "shadow-mask",
    .frames = {1},
    .cell = {128, 72},
    .always = {{"dither", "false"}, {"mask_size", "12"}},
    .companions = {{"white", {{"tone_map", "3"}}},
                   {"cell_height", {{"mask_type", "2"}}},
                   {"mask_unit", {{"mask_triads", "20"}}},
                   {"mask_triads", {{"mask_unit", "1"}}},
                   {"mask_snap", {{"mask_size", "9.4"}}},
                   {"scanline_period", {{"scanline_strength", "1"}}},
                   {"scanline_unit", {{"scanline_strength", "1"}, {"scanline_lines", "5"}}},
                   {"scanline_lines", {{"scanline_strength", "1"}, {"scanline_unit", "1"}}},
                   {"scanline_interlace",
                    {{"scanline_strength", "1"}, {"scanline_unit", "1"}, {"scanline_lines", "2"}}},
                   {"scanline_axis", {{"scanline_strength", "1"}}},
                   {"pulse_width", {{"pulse_intensity", "0.05"}}},
                   {"pulse_rate", {{"pulse_intensity", "0.05"}}}},
    .source = "pattern:smpte,size=128x72",
};
}  // namespace

TEST_CASE(
    "shadow-mask: ends of each parameter match golden pictures, and one changes the picture") {
    check_parameters(shadow_mask);
}

TEST_CASE("shadow-mask: each preset matches its golden picture, and all presets differ") {
    check_presets(shadow_mask);
}
