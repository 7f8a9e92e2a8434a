#include "lab/golden/golden_bounds.h"

#include <doctest/doctest.h>

TEST_CASE("bounds of golden pictures are read with and without their units") {
    CHECK(parse_levels("2/255") == 2.0);
    CHECK(parse_levels(" 1.5 ") == 1.5);
    CHECK(parse_percent("0.1 %") == 0.1);
    CHECK(parse_percent("0.1%") == 0.1);
    CHECK(parse_percent("100") == 100.0);
    for (const char* text : {"", "/255", "2/256", "-1", "256", "nan", "2 %", "0x2"})
        CHECK_FALSE(parse_levels(text).has_value());
    for (const char* text : {"", "%", "-0.1", "101 %", "inf", "1/255"})
        CHECK_FALSE(parse_percent(text).has_value());
    CHECK(parse_levels(levels_text(2.5)) == 2.5);
    CHECK(parse_percent(percent_text(0.25)) == 0.25);
}

TEST_CASE("pictures are equal if at most the share of pixels is beyond the bound") {
    Difference difference;
    difference.largest = 255.0;
    difference.share_beyond = 0.001;
    CHECK(is_within(difference, {.levels = 2.0, .percent = 0.1}));
    CHECK_FALSE(is_within(difference, {.levels = 2.0, .percent = 0.09}));
}
