#include "ui/widgets/typed_number.h"

#include <doctest/doctest.h>

#include <cmath>

TEST_CASE("a typed number may have a point, a comma, a sign, an exponent and its unit") {
    const NumberInfo info{.unit = "px"};
    CHECK(read_typed_number("0.5", info).value == 0.5);
    CHECK(read_typed_number("0,5", info).value == 0.5);
    CHECK(read_typed_number("-0,25", info).value == -0.25);
    CHECK(read_typed_number("+3", info).value == 3.0);
    CHECK(read_typed_number("1e3", info).value == 1000.0);
    CHECK(read_typed_number(" 2 px", info).value == 2.0);
    CHECK(read_typed_number("2px", info).value == 2.0);
    CHECK(read_typed_number("0,125", info).value == 0.125);  // thousands do not start with 0
    CHECK(read_typed_number("0,5", info).complaint.empty());
}

TEST_CASE("an invalid or ambiguous number changes nothing and is reported") {
    for (const char* text : {"abc", "1x", "1,2,3", "1.2,3", "1,000.5", "--1", "inf", "nan", "1e999",
                             "4,096", "12,500", "-1,000"}) {
        const TypedNumber typed = read_typed_number(text, {});
        CHECK_MESSAGE(!typed.value, text);
        CHECK_MESSAGE(typed.complaint.find(text) != std::string::npos, text);
    }
    const TypedNumber nothing = read_typed_number("  ", {});
    CHECK_FALSE(nothing.value);
    CHECK(nothing.complaint.empty());
}

TEST_CASE("a typed number is clamped to the hard limit, and the limit is reported") {
    const NumberInfo info{.unit = "s", .limit = Limit{0.0, 10.0}};
    CHECK(read_typed_number("11", info).value == 10.0);
    CHECK(read_typed_number("11", info).complaint.find("Limited to 10 s") != std::string::npos);
    CHECK(read_typed_number("-1", info).value == 0.0);
    CHECK(read_typed_number("-1", info).complaint.find("Limited to 0 s") != std::string::npos);
    CHECK(read_typed_number("10", info).complaint.empty());
}

TEST_CASE("for integers the nearest one is used and reported") {
    const TypedNumber typed = read_typed_number("2.7", {.is_whole = true});
    CHECK(typed.value == 3.0);
    CHECK_FALSE(typed.complaint.empty());
    CHECK(read_typed_number("2", {.is_whole = true}).complaint.empty());
}

TEST_CASE("a decay may be typed as a time, and elsewhere a time is not a number") {
    const NumberInfo info{.unit = "per 1/60 s", .limit = Limit{0.0, 1.0}, .is_decay = true};
    const auto is_near = [](const TypedNumber& typed, double wanted) {
        return typed.value && typed.complaint.empty() && std::abs(*typed.value - wanted) < 1e-12;
    };
    CHECK(is_near(read_typed_number("100 ms", info), std::exp2(-1.0 / 6.0)));
    CHECK(is_near(read_typed_number("0,125 s", info), std::exp2(-1.0 / 7.5)));
    CHECK(is_near(read_typed_number("10% 0.5 s", info), std::pow(10.0, -1.0 / 30.0)));
    CHECK(is_near(read_typed_number("0.92", info), 0.92));
    CHECK(is_near(read_typed_number("0.92 per 1/60 s", info), 0.92));
    CHECK(read_typed_number("soon", info).complaint.find("120 ms") != std::string::npos);
    CHECK_FALSE(read_typed_number("100 ms", {.unit = "per 1/60 s"}).value);
}
