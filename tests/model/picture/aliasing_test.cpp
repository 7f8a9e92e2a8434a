#include "model/picture/aliasing.h"

#include "about.h"
#include "model/look/value_text.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace {}  // namespace

TEST_CASE("a period of whole pixels has no moiré") {
    for (const double whole : {1.0, 2.0, 4.0, 100.0}) {
        CHECK(beat_of(whole) == std::numeric_limits<double>::infinity());
        CHECK_FALSE(visible_beat(whole, 1e9));
    }
}

TEST_CASE("the moiré beats between the period and the nearest whole period") {
    CHECK(beat_of(4.1) == about(164.0, 1e-9));  // 1 / (1/4 - 10/41)
    CHECK(beat_of(3.75) == about(60.0, 1e-9));  // 1 / (4/15 - 1/4)
    CHECK(beat_of(2.5) == about(15.0, 1e-9));   // 1 / (2/5 - 1/3)
    CHECK(beat_of(0.8) == about(4.0, 1e-9));    // 1 / (5/4 - 1)
    // 15 px hold 6 stripes of 2.5 px and 5 of 3 px: both coincide there.
    CHECK(beat_of(2.5) / 2.5 - beat_of(2.5) / 3.0 == about(1.0, 1e-9));
}

TEST_CASE(
    "moiré is visible if its beat fits into the picture and the stripes are coarse in pixels") {
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

TEST_CASE("periods without moiré are whole numbers from two pixels") {
    CHECK(safe_periods(0.5, 5.5) == std::vector<double>{2.0, 3.0, 4.0, 5.0});
    CHECK(safe_periods(2.5, 2.9).empty());
    CHECK(safe_periods(1.0, 1e9).size() == 999);
}

TEST_CASE("a period has the unit px per period, which is shown as px") {
    Parameter parameter;
    parameter.unit = "px";
    CHECK_FALSE(is_period(parameter));
    parameter.unit = "px a period";
    CHECK(is_period(parameter));
    parameter.unit = "px per period";
    CHECK(is_period(parameter));
    CHECK(shown_unit(parameter) == "px");
    parameter.type.rows = 2;
    CHECK_FALSE(is_period(parameter));
}

namespace {
Parameter number_of(const char* name, double initial, const char* period = "") {
    Parameter parameter;
    parameter.name = name;
    parameter.initial = Value(initial);
    parameter.range = {0.5, 1200.0, 0.0};
    parameter.period = period;
    parameter.bindings = {{0, name}};
    return parameter;
}

// A mask measured in px or in triads, and scanlines measured in source lines.
Look measured_look() {
    Look look;
    look.passes.resize(1);
    look.passes[0].scope = "crt/";
    look.parameters = {number_of("crt/unit", 0.0),
                       number_of("crt/size", 6.0, "$unit == 0 ? $size : 0"),
                       number_of("crt/triads", 320.0, "$unit == 0 ? 0 : $WIDTH / $triads"),
                       number_of("crt/lines", 1.0, "$unit == 0 ? 0 : $lines * $LINE")};
    return look;
}
}  // namespace

TEST_CASE("a period is evaluated from its expression, and only where it is in use") {
    const Look look = measured_look();
    const Values in_px;
    const Values in_triads{{"crt/unit", Value(1.0)}};
    const SourceRaster raster{{0.0, 1.0 / 240.0, 240}, {}};
    const PeriodTerms px{look, in_px, {800, 672}, raster};
    const PeriodTerms triads{look, in_triads, {800, 672}, raster};
    CHECK(period_of(look.parameters[1], 6.5, px) == 6.5);
    CHECK_FALSE(period_of(look.parameters[2], 320.0, px));
    CHECK_FALSE(period_of(look.parameters[1], 6.5, triads));
    CHECK(period_of(look.parameters[2], 320.0, triads) == 2.5);
    CHECK(period_of(look.parameters[3], 1.0, triads).value() == about(2.8, 1e-9));  // 672 / 240
    CHECK_FALSE(period_of(number_of("plain", 1.0), 4.0, px));
}

TEST_CASE("the suggested value gives a whole period, whether the period grows or shrinks with it") {
    const Look look = measured_look();
    const Values in_triads{{"crt/unit", Value(1.0)}};
    const PeriodTerms terms{look, in_triads, {800, 672}, {{0.0, 1.0 / 240.0, 240}, {}}};
    CHECK(whole_period_value(look.parameters[2], 300.0, terms).value() == about(800.0 / 3.0, 1e-6));
    CHECK(whole_period_value(look.parameters[3], 1.0, terms).value() ==
          about(240.0 * 3.0 / 672.0, 1e-6));
    Parameter narrow = look.parameters[2];
    narrow.range = {290.0, 310.0, 0.0};
    CHECK_FALSE(whole_period_value(narrow, 300.0, terms));
}

TEST_CASE("a period with an unknown name is an error at the parameter's line") {
    Look look = measured_look();
    CHECK(check_periods(look.parameters, look).empty());
    look.parameters[1].period = "$sise";
    look.parameters[1].declared = {"crt.frag", 7};
    const Diagnostics problems = check_periods(look.parameters, look);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].line == 7);
    CHECK(problems[0].message.starts_with("@period of 'crt/size': "));
}
