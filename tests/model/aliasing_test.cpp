#include "model/aliasing.h"

#include "about.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace {}  // namespace

TEST_CASE("a period of whole pixels beats with nothing") {
    for (const double whole : {1.0, 2.0, 4.0, 100.0}) {
        CHECK(beat_of(whole) == std::numeric_limits<double>::infinity());
        CHECK_FALSE(visible_beat(whole, 1e9));
    }
}

TEST_CASE("the beat is that of the period and the nearest whole one") {
    CHECK(beat_of(4.1) == about(164.0, 1e-9));  // 1 / (1/4 - 10/41)
    CHECK(beat_of(3.75) == about(60.0, 1e-9));  // 1 / (4/15 - 1/4)
    CHECK(beat_of(2.5) == about(15.0, 1e-9));   // 1 / (2/5 - 1/3)
    CHECK(beat_of(0.8) == about(4.0, 1e-9));    // 1 / (5/4 - 1)
    // 15 px hold 6 stripes of 2.5 px and 5 of 3 px: both meet again there.
    CHECK(beat_of(2.5) / 2.5 - beat_of(2.5) / 3.0 == about(1.0, 1e-9));
}

TEST_CASE(
    "a beat is seen that fits into the picture, of stripes that are coarse enough in pixels") {
    CHECK(visible_beat(4.1, 720.0).value() == about(164.0, 1e-9));
    CHECK_FALSE(visible_beat(4.1, 160.0));
    CHECK_FALSE(visible_beat(4.001, 1080.0));  // 16 004 px
    CHECK_FALSE(visible_beat(15.5, 1080.0));
    CHECK_FALSE(visible_beat(0.0, 1080.0));
    CHECK_FALSE(visible_beat(-3.0, 1080.0));
    CHECK(unevenness_of(3.0) == about(0.5, 1e-9));  // cos 60 degrees
    CHECK(unevenness_of(4.0) == about(1.0 - std::sqrt(0.5), 1e-9));
    CHECK(unevenness_of(1.5) == 1.0);
}

TEST_CASE("safe are whole periods from two pixels on") {
    CHECK(safe_periods(0.5, 5.5) == std::vector<double>{2.0, 3.0, 4.0, 5.0});
    CHECK(safe_periods(2.5, 2.9).empty());
    CHECK(safe_periods(1.0, 1e9).size() == 999);
}

TEST_CASE("a period is a number of px a period, and px behind a number") {
    Parameter parameter;
    parameter.unit = "px";
    CHECK_FALSE(is_period(parameter));
    parameter.unit = "px a period";
    CHECK(is_period(parameter));
    CHECK(shown_unit(parameter) == "px");
    parameter.type.rows = 2;
    CHECK_FALSE(is_period(parameter));
}
