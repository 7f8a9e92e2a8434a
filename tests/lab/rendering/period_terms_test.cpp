#include "lab/rendering/period_terms.h"

#include <doctest/doctest.h>

TEST_CASE("a period is reported as moiré, too fine or neither, with the nearest even value") {
    Parameter parameter;
    parameter.name = "size";
    parameter.unit = "px a period";
    parameter.range = {1.0, 16.0, 0.0};
    const Look look;
    const Values values;
    const PeriodTerms terms{look, values, {320, 240}, {}};
    const auto info_at = [&](double value) { return period_info(parameter, value, terms); };
    CHECK(info_at(4.0).period == 4.0);
    CHECK_FALSE(info_at(4.0).beat);
    CHECK_FALSE(info_at(4.0).even);
    CHECK(info_at(4.1).beat.value() == doctest::Approx(164.0));
    CHECK(info_at(4.1).even.value() == doctest::Approx(4.0));
    CHECK_FALSE(info_at(4.1).is_too_fine);
    CHECK(info_at(1.9).is_too_fine);
    CHECK_FALSE(info_at(1.9).beat);
    CHECK(info_at(1.9).even.value() == doctest::Approx(2.0));
    CHECK_FALSE(info_at(2.0).is_too_fine);
    parameter.unit = "px";
    CHECK_FALSE(info_at(1.9).period);
    CHECK_FALSE(info_at(1.9).is_too_fine);
}
