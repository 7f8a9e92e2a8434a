#include "ui/widgets/slider.h"

#include "about.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {}  // namespace

TEST_CASE("a fine drag moves a tenth as far, a coarse one ten times, both within the ends") {
    CHECK(is_near(dragged_share(0.5, 0.1, DragPace::fine), 0.51, 1e-9));
    CHECK(is_near(dragged_share(0.5, 0.01, DragPace::coarse), 0.6, 1e-9));
    CHECK(dragged_share(0.5, -0.2, DragPace::coarse) == 0.0);
}

TEST_CASE("a drag rounds to readable numbers, ten times finer or coarser by its pace") {
    const SliderInfo info{.low = 0.0, .high = 1.0};
    CHECK(is_near(dragged_value(0.123456, info, DragPace::direct), 0.123, 1e-9));
    CHECK(is_near(dragged_value(0.123456, info, DragPace::fine), 0.1235, 1e-9));
    CHECK(is_near(dragged_value(0.123456, info, DragPace::coarse), 0.12, 1e-9));
}

TEST_CASE("a slider with steps uses only these at any pace, counted from the look's low end") {
    SliderInfo odd{.low = 3.0, .high = 25.0, .step = 2.0};
    for (const DragPace pace : {DragPace::direct, DragPace::fine, DragPace::coarse})
        CHECK(dragged_value(0.2, odd, pace) == 7.0);  // rounded from 7.4
    odd.low = 4.0;
    odd.steps_from = 3.0;
    CHECK(dragged_value(0.0, odd, DragPace::direct) == 5.0);
}

TEST_CASE("notches mark the steps between the ends if there is room for all of them") {
    const SliderInfo info{.low = 0.0, .high = 4.0, .step = 1.0};
    const auto places = notch_ratios(info, 100.0);
    REQUIRE(places.size() == 3);
    CHECK(is_near(places[0], 0.25, 1e-9));
    CHECK(is_near(places[2], 0.75, 1e-9));
    CHECK(notch_ratios(info, 20.0).size() == 3);  // five pixels apart
    CHECK(notch_ratios(info, 19.0).empty());
    CHECK(notch_ratios({.low = 0.0, .high = 4.0}, 100.0).empty());  // no steps
    CHECK(notch_ratios({.low = 0.0, .high = 1e9, .step = 1e-3}, 100.0).empty());
    // 1, 2 .. 8 over three octaves: 7 and 8 are log2(8/7)/3 apart, 6.4 pixels of 100.
    const SliderInfo ratios{.low = 1.0, .high = 8.0, .step = 1.0, .scale = Scale::logarithmic};
    CHECK(notch_ratios(ratios, 100.0).size() == 6);
    CHECK(notch_ratios(ratios, 75.0).empty());
}

TEST_CASE("safe values are marked where there is room") {
    const SliderInfo info{.low = 2.0, .high = 12.0, .safe = {2.0, 3.0, 4.0, 12.0}};
    const auto places = safe_ratios(info, 100.0);
    REQUIRE(places.size() == 4);
    CHECK(is_near(places[1], 0.1, 1e-9));
    CHECK(safe_ratios(info, 30.0).size() == 3);  // 3 px apart: only every other one
}
