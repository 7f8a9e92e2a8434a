#include "base/fitted_number.h"

#include <doctest/doctest.h>

#include <limits>

TEST_CASE("a number is rounded to the most digits that fit the given width") {
    CHECK(fitted_number(1.0 / 3.0, 5) == "0.333");
    CHECK(fitted_number(-1.0 / 3.0, 5) == "-0.33");
    CHECK(fitted_number(1.0 / 3.0, 9) == "0.3333333");
    CHECK(fitted_number(2.0 / 3.0, 7) == "0.66667");
    CHECK(fitted_number(12.345, 5) == "12.35");
    CHECK(fitted_number(-12.345, 5) == "-12.3");
    CHECK(fitted_number(0.5, 5) == "0.5");
    CHECK(fitted_number(100.0, 5) == "100");
    CHECK(fitted_number(0.0, 5) == "0");
    CHECK(fitted_number(-0.0, 5) == "0");
}

TEST_CASE("a number too large or too small for the width is written with an exponent") {
    CHECK(fitted_number(65504.0, 5) == "65504");  // the largest half float
    CHECK(fitted_number(4294967295.0, 5) == "4.3e9");
    CHECK(fitted_number(70000.0, 5) == "70000");
    CHECK(fitted_number(-123456.0, 5) == "-1e5");
    CHECK(fitted_number(0.0000066, 5) == "7e-6");
    CHECK(fitted_number(1.5e-20, 7) == "1.5e-20");
    CHECK(fitted_number(1.4e-45, 5) == "1e-45");
}

TEST_CASE("non-finite numbers are written as Inf, -Inf and NaN") {
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(fitted_number(infinity, 5) == "Inf");
    CHECK(fitted_number(-infinity, 5) == "-Inf");
    CHECK(fitted_number(std::numeric_limits<double>::quiet_NaN(), 5) == "NaN");
}
