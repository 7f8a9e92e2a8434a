#include "model/tuning/one_step.h"

#include "about.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
Parameter slider(double low, double high, double step = 0.0) {
    Parameter made;
    made.name = "knob";
    made.label = "Knob";
    made.range = {low, high, step};
    return made;
}

double stepped(const Parameter& parameter, double number, bool up) {
    const auto next = one_step(parameter, Value(number), 0, up);
    REQUIRE(next.has_value());
    return next->number();
}

std::string disabled_reason(const Parameter& parameter, const Value& value, bool up = true) {
    const auto next = one_step(parameter, value, 0, up);
    REQUIRE_FALSE(next.has_value());
    return next.error().front().message;
}

}  // namespace

TEST_CASE("one step of a slider is its step size, else 1 % of its range") {
    CHECK(is_near(stepped(slider(0, 8, 0.5), 3.0, true), 3.5));
    CHECK(is_near(stepped(slider(0, 8, 0.5), 3.0, false), 2.5));
    CHECK(is_near(stepped(slider(2, 4), 3.0, true), 3.02));
    CHECK(is_near(stepped(slider(2, 4), 3.0, false), 2.98));
    CHECK(is_near(stepped(slider(2, 4), 3.995, true), 4.0));  // clamped to the maximum

    Parameter ratio = slider(0.1, 10.0);
    ratio.scale = Scale::logarithmic;
    CHECK(is_near(stepped(ratio, 1.0, true), std::pow(100.0, 0.01)));
    CHECK(is_near(stepped(ratio, 1.0, false), std::pow(100.0, -0.01)));
}

TEST_CASE("a step changes an integer by one, selects the next item of a list and flips a switch") {
    Parameter count = slider(1, 16);
    count.type.scalar = Scalar::integer;
    CHECK(stepped(count, 4, true) == 5.0);
    CHECK(stepped(count, 4, false) == 3.0);

    Parameter list = slider(0, 7);
    list.control = Control::list;
    list.items = {{0, "none"}, {3, "some"}, {7, "all"}};
    CHECK(stepped(list, 3, true) == 7.0);
    CHECK(stepped(list, 3, false) == 0.0);
    CHECK(disabled_reason(list, Value(7.0)) == "Knob is at its last item");
    CHECK(disabled_reason(list, Value(0.0), false) == "Knob is at its first item");

    Parameter toggle = slider(0, 1);
    toggle.type.scalar = Scalar::boolean;
    CHECK(stepped(toggle, 1, true) == 0.0);
    CHECK(stepped(toggle, 0, false) == 1.0);
}

TEST_CASE("a step changes one component of a vector, all of a colour, and the y of a point") {
    Parameter vector = slider(0, 10);
    vector.type.rows = 3;
    const auto next = one_step(vector, Value({1.0, 2.0, 3.0}), 1, true);
    REQUIRE(next.has_value());
    CHECK(next->numbers[0] == 1.0);
    CHECK(is_near(next->numbers[1], 2.1));
    CHECK(next->numbers[2] == 3.0);

    vector.control = Control::color;
    const auto lighter = one_step(vector, Value({0.2, 0.4, 0.0}), 1, true);
    REQUIRE(lighter.has_value());
    for (const std::size_t i : {0U, 1U, 2U})  // a tenth of a stop: 2^(1/10) = 1.0717734625
        CHECK(std::abs(lighter->numbers[i] - std::array{0.2, 0.4, 0.0}[i] * 1.0717734625) < 1e-9);
    CHECK(disabled_reason(vector, Value({0.0, 0.0, 0.0})) == "Knob is black or at its limit");

    vector.control = Control::point;
    vector.type.rows = 2;
    const auto raised = one_step(vector, Value({5.0, 5.0}), 0, true);
    REQUIRE(raised.has_value());
    CHECK(raised->numbers[0] == 5.0);
    CHECK(is_near(raised->numbers[1], 5.1));
}

TEST_CASE("a point is stepped over the range of its vertical axis") {
    Parameter point = slider(0, 1920);
    point.type.rows = 2;
    point.control = Control::point;
    point.initial = Value({960.0, 540.0});
    point.axes = {{0.0, 1920.0, 0.0}, {0.0, 1000.0, 0.0}};
    const auto next = one_step(point, point.initial, 0, true);
    REQUIRE(next.has_value());
    CHECK(is_near(next->numbers[0], 960.0));
    CHECK(is_near(next->numbers[1], 550.0));
}

TEST_CASE("a parameter at its limit or without steps returns the reason") {
    CHECK(disabled_reason(slider(0, 1), Value(1.0)) == "Knob is at its maximum");
    CHECK(disabled_reason(slider(0, 1), Value(0.0), false) == "Knob is at its minimum");
    CHECK(disabled_reason(slider(0, 1, 0.25), Value(1.0)) == "Knob is at its maximum");
    Parameter image = slider(0, 1);
    image.control = Control::image;
    CHECK(disabled_reason(image, Value::of_path("a.png")) == "Knob can't be changed in steps");
    Parameter matrix = slider(0, 1);
    matrix.type = {Scalar::floating, 2, 2};
    CHECK(disabled_reason(matrix, Value({1.0, 0.0, 0.0, 1.0})) == "Knob can't be changed in steps");
}
