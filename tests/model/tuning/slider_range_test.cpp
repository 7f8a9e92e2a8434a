#include "model/tuning/slider_range.h"

#include <doctest/doctest.h>

#include <cmath>

TEST_CASE("slider positions and values convert both ways") {
    const Range linear{-2.0, 6.0};
    CHECK(value_at(linear, Scale::linear, 0.25) == 0.0);
    CHECK(ratio_in(linear, Scale::linear, 4.0) == 0.75);
    const Range ratios{0.1, 1000.0};
    CHECK(std::abs(value_at(ratios, Scale::logarithmic, 0.5) - 10.0) < 1e-9);
    CHECK(std::abs(ratio_in(ratios, Scale::logarithmic, 1.0) - 0.25) < 1e-12);
    const Range from_zero{0.0, 8.0};  // a range that starts at 0 has no ratios: cubic
    CHECK(value_at(from_zero, Scale::logarithmic, 0.5) == 1.0);
    CHECK(std::abs(ratio_in(from_zero, Scale::logarithmic, 1.0) - 0.5) < 1e-12);
    CHECK(ratio_in(linear, Scale::linear, 99.0) == 1.0);
    CHECK(value_at(linear, Scale::linear, -1.0) == -2.0);
}

TEST_CASE("a value is rounded to the resolution of the slider") {
    const auto is_near = [](double value, double wanted) {
        return std::abs(value - wanted) < 1e-9;
    };
    CHECK(is_near(readable({0.0, 1.0}, Scale::linear, 0.123456), 0.123));
    CHECK(is_near(readable({0.0, 1.0}, Scale::linear, 0.123456, 10.0), 0.12));
    CHECK(is_near(readable({0.0, 1.0}, Scale::linear, 0.123456, 0.1), 0.1235));
    CHECK(is_near(readable({0.1, 16.0}, Scale::logarithmic, 0.123456), 0.1235));
    CHECK(is_near(readable({0.1, 16.0}, Scale::logarithmic, 12.3456), 12.35));
    CHECK(readable({0.0, 0.9999}, Scale::linear, 0.99989) == 0.9999);  // not beyond the maximum
}

TEST_CASE("steps count from the shader's minimum, also with custom ends") {
    const auto odd = steps_in({3.0, 25.0, 2.0}, 3.0);
    REQUIRE(odd.has_value());
    CHECK(odd->first == 3.0);
    CHECK(odd->count == 12.0);
    CHECK(odd->nearest(8.2) == 9.0);
    CHECK(odd->nearest(99.0) == 25.0);
    const auto moved = steps_in({4.0, 10.0, 2.0}, 3.0);
    REQUIRE(moved.has_value());
    CHECK(moved->first == 5.0);
    CHECK(moved->count == 3.0);
    const auto tenths = steps_in({0.0, 0.3, 0.1}, 0.0);  // 0.3 / 0.1 is below 3 in doubles
    REQUIRE(tenths.has_value());
    CHECK(tenths->count == 4.0);
    CHECK_FALSE(steps_in({0.0, 1.0, 0.0}, 0.0).has_value());
    CHECK_FALSE(steps_in({0.2, 0.8, 1.0}, 0.0).has_value());
}

TEST_CASE("integers have a step of one") {
    Parameter parameter;
    parameter.range = {0.0, 4.0};
    CHECK(step_of(parameter) == 0.0);
    parameter.type.scalar = Scalar::integer;
    CHECK(step_of(parameter) == 1.0);
    parameter.range.step = 2.0;
    CHECK(step_of(parameter) == 2.0);
}
