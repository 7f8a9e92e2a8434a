#include "model/look/decay.h"

#include "about.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace {}  // namespace

TEST_CASE("a half-life converts to a factor per 1/60 s and back") {
    CHECK(is_near(factor_leaving(0.5, 1.0 / 60.0), 0.5));
    CHECK(is_near(factor_leaving(0.5, 2.0 / 60.0), std::sqrt(0.5)));
    CHECK(is_near(half_life(0.25), 1.0 / 120.0));
    for (const double seconds : {0.001, 0.12, 3.0})
        CHECK(is_near(half_life(factor_leaving(0.5, seconds)), seconds));
    // The factor is 2^(-1/(60 h)) per frame of 1/60 s: a half-life of 0.1 s is six frames.
    CHECK(is_near(std::pow(factor_leaving(0.5, 0.1), 6.0), 0.5));
}

TEST_CASE("a time to 10 % converts to a factor and back") {
    CHECK(is_near(factor_leaving(0.1, 1.0 / 60.0), 0.1));
    CHECK(is_near(seconds_to(0.1, 0.1), 1.0 / 60.0));
    CHECK(is_near(std::pow(factor_leaving(0.1, 0.4), 24.0), 0.1));
    // The times to 1/10 and 1/2 have the ratio log2(10), for every factor.
    CHECK(is_near(seconds_to(0.1, 0.92) / half_life(0.92), std::log2(10.0)));
}

TEST_CASE("factor 0 has half-life 0, and factor 1 never decays") {
    CHECK(half_life(0.0) == 0.0);
    CHECK(half_life(1.0) == std::numeric_limits<double>::infinity());
    CHECK(duration_text(half_life(1.0)) == "forever");
}

TEST_CASE("a decay is parsed as a half-life, or as a remaining share and a time") {
    CHECK(is_near(*parse_decay("120 ms"), std::exp2(-1.0 / 7.2)));
    CHECK(is_near(*parse_decay("120ms"), std::exp2(-1.0 / 7.2)));
    CHECK(is_near(*parse_decay(" 0.5 s "), std::exp2(-1.0 / 30.0)));
    CHECK(is_near(*parse_decay("0,5 s"), std::exp2(-1.0 / 30.0)));
    CHECK(is_near(*parse_decay("10% 0.4 s"), std::pow(10.0, -1.0 / 24.0)));
    CHECK(is_near(*parse_decay("10 % 400 ms"), std::pow(10.0, -1.0 / 24.0)));
    CHECK(is_near(*parse_decay("50% 1 s"), *parse_decay("1 s")));
    for (const char* text : {"0.92", "s", "ms", "0 s", "-1 s", "10%", "0% 1 s", "100% 1 s",
                             "x% 1 s", "10% x", "10% 0", "1 h", ""})
        CHECK_MESSAGE(!parse_decay(text), text);
}

TEST_CASE("a duration is shown in ms or s with three digits") {
    CHECK(duration_text(0.13862) == "139 ms");
    CHECK(duration_text(0.0012) == "1.2 ms");
    CHECK(duration_text(0.0999) == "99.9 ms");
    CHECK(duration_text(0.9999) == "1 s");
    CHECK(duration_text(1.45) == "1.45 s");
    CHECK(duration_text(690.0) == "690 s");
    CHECK(duration_text(0.0) == "0 ms");
}

TEST_CASE("a parameter is a decay if it is one number with the unit per 1/60 s") {
    Parameter parameter;
    CHECK_FALSE(is_decay(parameter));
    parameter.unit = "per 1/60 s";
    CHECK(is_decay(parameter));
    parameter.range.high = 60.0;  // a number of points
    CHECK_FALSE(is_decay(parameter));
    parameter.range.high = 1.0;
    parameter.type.rows = 3;
    CHECK_FALSE(is_decay(parameter));
}
