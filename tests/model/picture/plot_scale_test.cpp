#include "model/picture/plot_scale.h"

#include <doctest/doctest.h>

#include <cmath>

TEST_CASE("the end of a plot is rounded up to a round number") {
    CHECK(rounded_up(0.93) == 1.0);
    CHECK(rounded_up(1.0) == 1.0);
    CHECK(rounded_up(1.01) == 1.5);
    CHECK(rounded_up(2.5) == 3.0);
    CHECK(rounded_up(6.5) == 8.0);
    CHECK(rounded_up(8.1) == 10.0);
    CHECK(rounded_up(65504.0) == 80000.0);
    CHECK(std::abs(rounded_up(0.012) - 0.015) <= 1e-12);
    CHECK(rounded_up(0.0) == 0.0);
    CHECK(rounded_up(-3.0) == 0.0);
}

TEST_CASE("the numbers on a scale are round, and limited by the available space") {
    CHECK(axis_ticks({0.0, 1.0}, 3) == std::vector{0.0, 0.5, 1.0});
    CHECK(axis_ticks({0.0, 3.0}, 4) == std::vector{0.0, 1.0, 2.0, 3.0});
    CHECK(axis_ticks({0.0, 3.0}, 3) == std::vector{0.0, 2.0});
    CHECK(axis_ticks({-1.5, 2.0}, 8) == std::vector{-1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0});
    CHECK(axis_ticks({0.0, 639.0}, 4) == std::vector{0.0, 200.0, 400.0, 600.0});
    CHECK(axis_ticks({0.0, 0.0}, 4) == std::vector{0.0});
}

TEST_CASE("a plot range grows at once, and shrinks after two seconds") {
    SteadyRange range;
    range.cover(0.0, 0.9, 10.0);
    CHECK(range.current() == PlotRange{0.0, 1.0});
    range.cover(-0.2, 7.0, 10.2);
    CHECK(range.current() == PlotRange{-0.2, 8.0});
    range.cover(0.0, 0.9, 11.0);
    CHECK(range.current() == PlotRange{-0.2, 8.0});
    range.cover(-0.2, 7.5, 12.0);  // the full range is needed again
    range.cover(0.0, 0.9, 13.9);
    CHECK(range.current() == PlotRange{-0.2, 8.0});
    range.cover(0.0, 0.9, 14.1);
    CHECK(range.current() == PlotRange{0.0, 1.0});
    range.cover(0.0, 0.0, 20.0);
    CHECK(range.current() == PlotRange{0.0, 1.0});  // all-zero data keeps the range
}
