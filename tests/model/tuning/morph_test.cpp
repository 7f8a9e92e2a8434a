#include "model/tuning/morph.h"

#include "about.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace {
constexpr double pi = std::numbers::pi;

Parameter morphed_parameter(Range range, Control control = Control::slider) {
    Parameter made;
    made.name = "knob";
    made.range = range;
    made.control = control;
    made.initial = Value(0.0);
    return made;
}

Value between(const Parameter& parameter, const Value& from, const Value& to, double share) {
    Look look;
    look.parameters = {parameter};
    return value_of(parameter, morphed(look, {{"knob", from}}, {{"knob", to}}, share));
}

}  // namespace

TEST_CASE("numbers morph linearly, or by ratio on a logarithmic slider") {
    const Parameter plain = morphed_parameter({0, 10, 0});
    CHECK(is_near(between(plain, 2.0, 6.0, 0.25).number(), 3.0));
    CHECK(between(plain, 2.0, 6.0, 0.0) == Value(2.0));
    CHECK(between(plain, 2.0, 6.0, 1.0) == Value(6.0));
    Parameter ratio = morphed_parameter({0.1, 100, 0});
    ratio.scale = Scale::logarithmic;
    CHECK(is_near(between(ratio, 1.0, 64.0, 0.5).number(), 8.0));
    CHECK(is_near(between(ratio, 0.0, 64.0, 0.5).number(), 32.0));  // from 0: linear
}

TEST_CASE("colours morph linearly in light") {
    Parameter color = morphed_parameter({0, 1, 0}, Control::color);
    color.type.rows = 3;
    const Value middle = between(color, Value({1.0, 0.0, 0.2}), Value({0.0, 0.5, 0.2}), 0.5);
    CHECK(is_near(middle.numbers[0], 0.5));
    CHECK(is_near(middle.numbers[1], 0.25));
    CHECK(is_near(middle.numbers[2], 0.2));
}

TEST_CASE("a full-circle angle morphs the shorter way, a limited one along its range") {
    const Parameter round = morphed_parameter({-3.1416, 3.1416, 0}, Control::angle);
    CHECK(std::abs(between(round, 0.9 * pi, -0.9 * pi, 0.25).number() - 0.95 * pi) < 1e-9);
    CHECK(std::abs(between(round, 0.9 * pi, -0.9 * pi, 0.75).number() + 0.95 * pi) < 1e-9);
    const Parameter quarter = morphed_parameter({-1.6, 1.6, 0}, Control::angle);
    CHECK(is_near(between(quarter, 1.5, -1.5, 0.5).number(), 0.0));
}

TEST_CASE("integers, lists, switches and files change halfway through a morph") {
    Parameter count = morphed_parameter({0, 10, 0});
    count.type.scalar = Scalar::integer;
    Parameter toggle = morphed_parameter({0, 1, 0});
    toggle.type.scalar = Scalar::boolean;
    const Parameter list = morphed_parameter({0, 7, 0}, Control::list);
    for (const Parameter& parameter : {count, toggle, list}) {
        CHECK(between(parameter, 0.0, 1.0, 0.499) == Value(0.0));
        CHECK(between(parameter, 0.0, 1.0, 0.5) == Value(1.0));
    }
    const Parameter image = morphed_parameter({0, 1, 0}, Control::image);
    CHECK(between(image, Value::of_path("a"), Value::of_path("b"), 0.4).path == "a");
    CHECK(between(image, Value::of_path("a"), Value::of_path("b"), 0.6).path == "b");
}

TEST_CASE("a parameter of only one preset morphs from or to its default; unknown values stay") {
    Parameter first = morphed_parameter({0, 10, 0});
    first.name = "first";
    Parameter second = first;
    second.name = "second";
    second.initial = Value(4.0);
    Look look;
    look.parameters = {first, second};
    const Values middle =
        morphed(look, {{"first", Value(2.0)}, {"gone", Value(7.0)}}, {{"second", Value(8.0)}}, 0.5);
    CHECK(is_near(middle.at("first").number(), 1.0));
    CHECK(is_near(middle.at("second").number(), 6.0));
    CHECK(middle.at("gone") == Value(7.0));
    const Values all{{"second", Value(8.0)}};
    CHECK(morphed(look, {{"first", Value(2.0)}}, all, 1.0) == all);
}
