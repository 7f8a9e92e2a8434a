#include "model/look/value_text.h"

#include <doctest/doctest.h>

#include <numbers>

TEST_CASE("a value is formatted as its control displays it") {
    Parameter parameter;
    CHECK(value_text(parameter, Value(0.92)) == "0.92");
    CHECK(value_text(parameter, Value(1.0 / 3.0)) == "0.3333");
    CHECK(value_text(parameter, Value(1.0 / 3.0), 6) == "0.333333");
    CHECK(value_text(parameter, Value(12345.6)) == "12350");
    CHECK(value_text(parameter, Value({0.5, 1.0, -2.0})) == "0.5, 1, -2");
    CHECK(value_text(parameter, Value{}) == "none");
    CHECK(value_text(parameter, Value::of_path("/home/a/dirt.png")) == "dirt.png");

    parameter.items = {{0.0, "Clamp"}, {1.0, "Reinhard"}};
    CHECK(value_text(parameter, Value(1.0)) == "Reinhard");
    CHECK(value_text(parameter, Value(7.0)) == "7");

    Parameter on_off;
    on_off.type.scalar = Scalar::boolean;
    CHECK(value_text(on_off, Value(1.0)) == "on");

    Parameter angle;
    angle.control = Control::angle;
    CHECK(value_text(angle, Value(std::numbers::pi / 6.0)) == "30");
    CHECK(unit_text(angle) == "°");
}

TEST_CASE("a colour is formatted as sRGB hex, or as numbers when it is out of range") {
    Parameter color;
    color.control = Control::color;
    // IEC 61966-2-1: a linear 0.2158605 is 0.5020 = 128 of 255.
    CHECK(value_text(color, Value({1.0, 0.2158605, 0.0})) == "#ff8000");
    CHECK(value_text(color, Value({2.0, 0.5, 0.0})) == "2, 0.5, 0");
}
