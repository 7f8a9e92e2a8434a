#include "model/tuning/slider_share.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
Parameter ranged(Range range, Scale scale = Scale::linear) {
    Parameter made;
    made.name = "knob";
    made.range = range;
    made.scale = scale;
    made.initial = Value(range.low);
    return made;
}

double number(const Parameter& parameter, double share, const ParameterSetting& setting = {}) {
    return value_at_share({parameter, setting}, parameter.initial, share).number();
}

bool is_close(double a, double b) {
    return std::abs(a - b) <= 1e-9;
}
}  // namespace

TEST_CASE("a share maps to the slider linearly, or by equal ratios on a logarithmic scale") {
    const Parameter plain = ranged({-1.0, 3.0});
    CHECK(number(plain, 0.0) == -1.0);
    CHECK(number(plain, 1.0) == 3.0);
    CHECK(is_close(number(plain, 0.25), 0.0));
    CHECK(is_close(share_at({plain, {}}, Value(0.0)), 0.25));
    CHECK(share_at({plain, {}}, Value(9.0)) == 1.0);  // typed beyond the end of the slider
    const Parameter ratios = ranged({1.0, 100.0}, Scale::logarithmic);
    CHECK(is_close(number(ratios, 0.5), 10.0));
    CHECK(is_close(share_at({ratios, {}}, Value(10.0)), 0.5));
    const ParameterSetting ends{.ends = Limit{0.0, 0.5}};
    CHECK(is_close(number(plain, 0.5, ends), 0.25));
    CHECK(is_close(share_at({plain, ends}, Value(0.25)), 0.5));
}

TEST_CASE("a half-life slider has equal ratios of half-lives") {
    // A factor d has the half-life ln(1/2) / (60 ln d).
    const auto factor = [](double seconds) { return std::pow(0.5, 1.0 / (60.0 * seconds)); };
    const Parameter decay = ranged({factor(0.01), factor(1.0)}, Scale::half_life);
    CHECK(is_close(number(decay, 0.0), factor(0.01)));
    CHECK(is_close(number(decay, 0.5), factor(0.1)));
    CHECK(is_close(number(decay, 1.0), factor(1.0)));
    CHECK(is_close(share_at({decay, {}}, Value(factor(0.1))), 0.5));
    const Parameter whole = ranged({0.0, 1.0}, Scale::half_life);  // 1 ms to 100 s, then the ends
    CHECK(number(whole, 0.0) == 0.0);
    CHECK(number(whole, 1.0) == 1.0);
    CHECK(is_close(number(whole, 0.4), factor(0.1)));
    CHECK(share_at({whole, {}}, Value(0.0)) == 0.0);
    CHECK(share_at({whole, {}}, Value(1.0)) == 1.0);
}

TEST_CASE("steps, integers, lists and switches map to exact values") {
    Parameter odd = ranged({3.0, 25.0, 2.0});
    CHECK(number(odd, 0.45) == 13.0);  // 12.9
    CHECK(number(odd, 0.03) == 3.0);
    CHECK(number(odd, 1.0) == 25.0);
    Parameter whole = ranged({0.0, 10.0});
    whole.type.scalar = Scalar::integer;
    CHECK(number(whole, 0.24) == 2.0);
    Parameter list = ranged({0.0, 9.0});
    list.control = Control::list;
    list.items = {{0, "None"}, {4, "Mask"}, {9, "All"}};
    CHECK(number(list, 0.0) == 0.0);
    CHECK(number(list, 0.33) == 0.0);
    CHECK(number(list, 0.34) == 4.0);
    CHECK(number(list, 1.0) == 9.0);
    CHECK(is_close(share_at({list, {}}, Value(4.0)), 0.5));
    CHECK_FALSE(is_gradual(list));
    Parameter toggle = ranged({0.0, 1.0});
    toggle.type.scalar = Scalar::boolean;
    CHECK(number(toggle, 63.0 / 127.0) == 0.0);
    CHECK(number(toggle, 64.0 / 127.0) == 1.0);
    CHECK_FALSE(is_gradual(toggle));
}

TEST_CASE("one component of a vector can be controlled; colours, files and matrices cannot") {
    Parameter point = ranged({0.0, 2.0});
    point.type = {Scalar::floating, 2};
    point.initial = Value({0.5, 0.5});
    CHECK(value_at_share({point, {}, 1}, point.initial, 0.75) == Value({0.5, 1.5}));
    CHECK(has_slider_numbers(point));
    CHECK(is_gradual(point));
    for (const Control control : {Control::color, Control::image, Control::sound}) {
        Parameter other = ranged({0.0, 1.0});
        other.control = control;
        CHECK_FALSE(has_slider_numbers(other));
    }
    point.type = {Scalar::floating, 2, 2};
    CHECK_FALSE(has_slider_numbers(point));
}
