#include "model/look/parameter.h"

#include "about.h"
#include "model/look/color.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace {
Parameter typed_parameter(NumberType type, Value initial) {
    Parameter made;
    made.name = "knob";
    made.type = type;
    made.initial = std::move(initial);
    return made;
}
}  // namespace

TEST_CASE("a type is named as in GLSL") {
    CHECK(glsl_name({Scalar::floating, 1, 1}) == "float");
    CHECK(glsl_name({Scalar::unsigned_integer, 1, 1}) == "uint");
    CHECK(glsl_name({Scalar::boolean, 4, 1}) == "bvec4");
    CHECK(glsl_name({Scalar::integer, 2, 1}) == "ivec2");
    CHECK(glsl_name({Scalar::floating, 3, 3}) == "mat3");
    CHECK(glsl_name({Scalar::floating, 3, 2}) == "mat2x3");  // columns x rows
}

TEST_CASE("a colour is named instead of its GLSL type") {
    Parameter parameter = typed_parameter({Scalar::floating, 3, 1}, Value({1, 1, 1}));
    CHECK(type_name(parameter) == "vec3");
    parameter.control = Control::color;
    CHECK(type_name(parameter) == "color");
    parameter.control = Control::angle;
    CHECK(type_name(parameter) == "vec3");
}

TEST_CASE("a value is clamped to the hard limit, not to the soft range") {
    Parameter parameter = typed_parameter({}, 1.0);
    parameter.range = {0, 1};
    CHECK(clamped(parameter, 5.0) == Value(5.0));
    parameter.limit = Limit{0, 2};
    CHECK(clamped(parameter, 5.0) == Value(2.0));
    CHECK(clamped(parameter, -1.0) == Value(0.0));
}

TEST_CASE("a non-finite value becomes the default") {
    const Parameter parameter = typed_parameter({}, 0.25);
    CHECK(clamped(parameter, std::nan("")) == Value(0.25));
    CHECK(clamped(parameter, std::numeric_limits<double>::infinity()) == Value(0.25));
}

TEST_CASE("integers are rounded and clamped to 32 bits; booleans become 0 or 1") {
    CHECK(clamped(typed_parameter({Scalar::integer}, 0.0), 2.6) == Value(3.0));
    CHECK(clamped(typed_parameter({Scalar::integer}, 0.0), 1e30) == Value(2147483647.0));
    CHECK(clamped(typed_parameter({Scalar::unsigned_integer}, 0.0), -3.0) == Value(0.0));
    CHECK(clamped(typed_parameter({Scalar::unsigned_integer}, 0.0), 1e30) == Value(4294967295.0));
    CHECK(clamped(typed_parameter({Scalar::boolean}, 0.0), 0.3) == Value(1.0));
}

TEST_CASE("missing components are taken from the default; extra ones are dropped") {
    const Parameter parameter = typed_parameter({Scalar::floating, 3, 1}, Value({1, 2, 3}));
    CHECK(clamped(parameter, Value(std::vector<double>{9})) == Value({9, 2, 3}));
    CHECK(clamped(parameter, Value({9, 8, 7, 6})) == Value({9, 8, 7}));
}

TEST_CASE("a typed value is a list of numbers separated by commas") {
    const Parameter parameter = typed_parameter({Scalar::floating, 2, 1}, Value({0, 0}));
    CHECK(parse_value(parameter, " 0.5 , -1e2 ").value() == Value({0.5, -100}));
    const auto short_one = parse_value(parameter, "1");
    REQUIRE_FALSE(short_one.has_value());
    CHECK(short_one.error().front().message == "'knob' must have 2 numbers, got 1");
    const auto words = parse_value(parameter, "1,much");
    REQUIRE_FALSE(words.has_value());
    CHECK(words.error().front().message == "'knob' must be 2 numbers, got 'much'");
    CHECK_FALSE(parse_value(parameter, "").has_value());
    CHECK_FALSE(parse_value(parameter, "nan,1").has_value());
}

TEST_CASE("a list accepts an item's label in any case; a switch accepts words") {
    Parameter list = typed_parameter({Scalar::integer}, 0.0);
    list.control = Control::list;
    list.items = {{0, "Clamp"}, {2, "ACES"}};
    CHECK(parse_value(list, "aces").value() == Value(2.0));
    CHECK(parse_value(list, "0").value() == Value(0.0));
    const Parameter toggle = typed_parameter({Scalar::boolean}, 0.0);
    CHECK(parse_value(toggle, "on").value() == Value(1.0));
    CHECK(parse_value(toggle, "false").value() == Value(0.0));
}

TEST_CASE("a typed colour is sRGB, and is stored as linear light") {
    Parameter color = typed_parameter({Scalar::floating, 4, 1}, Value({0, 0, 0, 1}));
    color.control = Control::color;
    const Value value = parse_value(color, "#ff8000").value();
    REQUIRE(value.numbers.size() == 4);
    CHECK(value.numbers[0] == doctest::Approx(1.0));
    CHECK(value.numbers[1] == about(0.215861, 1e-5));  // sRGB 128/255
    CHECK(value.numbers[2] == 0.0);
    CHECK(value.numbers[3] == 1.0);
    CHECK_FALSE(parse_value(color, "#ff80").has_value());
    CHECK_FALSE(parse_value(color, "#ff80zz").has_value());
}

TEST_CASE("the value of an image is a path") {
    Parameter image = typed_parameter({}, Value::of_path(""));
    image.control = Control::image;
    CHECK(parse_value(image, " photo,1.png ").value() == Value::of_path("photo,1.png"));
    CHECK(clamped(image, Value::of_path("photo.png")) == Value::of_path("photo.png"));
}

TEST_CASE("the sRGB curve matches the standard, and decoding inverts encoding") {
    CHECK(srgb_encode(0.0) == 0.0);
    CHECK(srgb_encode(0.002) == about(12.92 * 0.002, 1e-9));  // the linear segment
    CHECK(srgb_encode(1.0) == doctest::Approx(1.0));
    CHECK(srgb_decode(0.5) == about(0.214041, 1e-5));
    for (const double light : {0.001, 0.0031308, 0.18, 0.9})
        CHECK(srgb_decode(srgb_encode(light)) == about(light, 1e-6));
}

TEST_CASE("a decay can be typed as a half-life") {
    Parameter typed_parameter;
    typed_parameter.name = "decay";
    typed_parameter.unit = "per 1/60 s";
    const auto value = parse_value(typed_parameter, "100 ms");
    REQUIRE(value.has_value());
    CHECK(std::abs(value->number() - std::exp2(-1.0 / 6.0)) < 1e-12);
}
