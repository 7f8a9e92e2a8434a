#include "formats/isf/controls.h"

#include <doctest/doctest.h>

namespace {
using Type = IsfInput::Type;

Parameter control_of(Type type, std::vector<double> initial = {}, std::vector<double> low = {},
                     std::vector<double> high = {}) {
    IsfInput input;
    input.type = type;
    input.name = "knob";
    input.initial = std::move(initial);
    input.low = std::move(low);
    input.high = std::move(high);
    return isf_control(input);
}
}  // namespace

TEST_CASE("a float is a slider over its range, or 0 to 1 if an end is missing") {
    const Parameter whole = control_of(Type::floating, {3.0}, {2.0}, {6.0});
    CHECK(whole.control == Control::slider);
    CHECK(whole.range == Range{2.0, 6.0, 0.0});
    CHECK(whole.initial == Value(3.0));
    CHECK(control_of(Type::floating, {}, {2.0}).range == Range{0.0, 1.0, 0.0});
    CHECK(control_of(Type::floating, {}, {}, {2.0}).range == Range{0.0, 1.0, 0.0});
}

TEST_CASE("a float without a default starts in the middle, and an outside default is clamped") {
    CHECK(control_of(Type::floating, {}, {2.0}, {6.0}).initial == Value(4.0));
    CHECK(control_of(Type::floating, {9.0}, {2.0}, {6.0}).initial == Value(6.0));
    CHECK(control_of(Type::floating, {3.0}, {6.0}, {2.0}).range == Range{2.0, 6.0, 0.0});
}

TEST_CASE("a bool without a default is on, and an event is off") {
    const Parameter on = control_of(Type::boolean);
    CHECK(on.type.scalar == Scalar::boolean);
    CHECK(on.initial == Value(1.0));
    CHECK(control_of(Type::boolean, {0.0}).initial == Value(0.0));
    CHECK(control_of(Type::event).control == Control::event);
    CHECK(control_of(Type::event).initial == Value(0.0));
}

TEST_CASE("a long is a list of its values, else an integer slider") {
    IsfInput input;
    input.type = Type::integer;
    input.values = {10.0, 20.0, 30.0};
    input.labels = {"ten", "twenty"};
    input.initial = {20.0};
    const Parameter list = isf_control(input);
    CHECK(list.control == Control::list);
    CHECK(list.type.scalar == Scalar::integer);
    CHECK(list.items == std::vector<Item>{{10.0, "ten"}, {20.0, "twenty"}, {30.0, "30"}});
    CHECK(list.initial == Value(20.0));
    input.initial = {25.0};
    CHECK(isf_control(input).initial == Value(10.0));
    const Parameter slider = control_of(Type::integer, {4.0}, {0.0}, {9.0});
    CHECK(slider.control == Control::slider);
    CHECK(slider.range == Range{0.0, 9.0, 1.0});
}

TEST_CASE("each axis of a point has its own range, and the common range contains both") {
    const Parameter point = control_of(Type::point, {64.0, 36.0}, {1.5, 1.0}, {900.0, 600.0});
    CHECK(point.control == Control::point);
    CHECK(point.type == NumberType{Scalar::floating, 2, 1});
    CHECK(point.axes == std::vector<Range>{{1.5, 900.0, 0.0}, {1.0, 600.0, 0.0}});
    CHECK(point.range == Range{1.0, 900.0, 0.0});
    CHECK(control_of(Type::point, {}, {0.0, 0.0}, {2.0, 2.0}).axes.empty());
    CHECK(point.initial == Value({64.0, 36.0}));
    CHECK(control_of(Type::point).initial == Value({0.5, 0.5}));
}

TEST_CASE("a colour is stored as linear light, and the shader gets it display-encoded") {
    const Parameter color = control_of(Type::color, {0.5, 1.0, 0.0, 0.25});
    CHECK(color.control == Control::color);
    CHECK(color.encoding == Encoding::display);
    // IEC 61966-2-1: 0.5 is 0.21404 of full light; alpha is not encoded.
    CHECK(color.initial.numbers[0] == doctest::Approx(0.21404).epsilon(1e-4));
    CHECK(color.initial.numbers[1] == doctest::Approx(1.0));
    CHECK(color.initial.numbers[2] == 0.0);
    CHECK(color.initial.numbers[3] == 0.25);
    CHECK(control_of(Type::color).initial == Value({1.0, 1.0, 1.0, 1.0}));
}

TEST_CASE("the identity value of a filter is read") {
    IsfInput input;
    input.name = "gain";
    input.identity = {1.0};
    CHECK(isf_control(input).identity == Value(1.0));
    input.identity = {1.0, 2.0};
    CHECK_FALSE(isf_control(input).identity.has_value());
}

TEST_CASE("a point without a range has one centred at its default") {
    CHECK(control_of(Type::point, {300.0, 200.0}).axes ==
          std::vector<Range>{{0.0, 600.0, 0.0}, {0.0, 400.0, 0.0}});
    CHECK(control_of(Type::point, {300.0, 200.0}).range == Range{0.0, 600.0, 0.0});
    CHECK(control_of(Type::point, {-3.0, 0.5}).range == Range{-6.0, 1.0, 0.0});
    CHECK(control_of(Type::point, {1.0, 0.0}).range == Range{0.0, 1.0, 0.0});
}
