#include "formats/shadertoy_export/shadertoy_constants.h"

#include "glsl/annotations/annotation.h"
#include "glsl/constants/constants.h"

#include <doctest/doctest.h>

namespace {
Parameter parameter(const std::string& name, double value) {
    Parameter made;
    made.name = name;
    made.label = "Label of " + name;
    made.initial = Value(value);
    made.bindings = {{0, name}};
    return made;
}

std::vector<ShadertoyConstant> constants_of(const Look& look) {
    EffectNames names;
    return shadertoy_constants(look, effect_controls(look, {}, {}, names), names);
}

// As the program reads it from the exported text.
Parameter read_again(const ShadertoyConstant& constant, std::size_t part = 0) {
    const auto found = find_constants(constant.text);
    REQUIRE(found.size() == constant.names.size());
    CHECK(found[part].name == constant.names[part]);
    Parameter parameter;
    parameter.name = found[part].name;
    parameter.type = found[part].type;
    parameter.initial = Value(*found[part].number);
    Diagnostics errors;
    annotate(parameter, parse_hints(found[part].comments, {}, errors), errors);
    CHECK(errors.empty());
    return parameter;
}
}  // namespace

TEST_CASE("quotes, backslashes and newlines in hints are read again") {
    Look look;
    look.parameters = {parameter("gain", 0.5)};
    Parameter& gain = look.parameters[0];
    gain.label = "\"quoted\" */ \\";
    gain.help = "one\ntwo @range 5 6";
    gain.group = "@group";
    gain.range = {-1.0, 4.0, 0.25};
    gain.limit = Limit{-2.0, 8.0};
    const Parameter again = read_again(constants_of(look)[0]);
    CHECK(again.label == gain.label);
    CHECK(again.help == "one two @range 5 6");
    CHECK(again.group == gain.group);
    CHECK(again.range == gain.range);
    CHECK(again.limit == gain.limit);
    CHECK(again.initial == gain.initial);
}

TEST_CASE("a list keeps its items, and numbers that are not 0, 1, 2 a range") {
    Look look;
    look.parameters = {parameter("kind", 1.0)};
    Parameter& kind = look.parameters[0];
    kind.type.scalar = Scalar::integer;
    kind.control = Control::list;
    kind.items = {{0.0, "None"}, {1.0, "Some", "", "a note"}};
    const Parameter again = read_again(constants_of(look)[0]);
    CHECK(again.items == kind.items);
    kind.items[1].value = 3.0;
    kind.initial = Value(3.0);
    CHECK(read_again(constants_of(look)[0]).range == Range{0.0, 3.0, 1.0});
}

TEST_CASE("a colour is one constant per channel") {
    Look look;
    look.parameters = {parameter("tint", 0.0)};
    look.parameters[0].type = {Scalar::floating, 3, 1};
    look.parameters[0].control = Control::color;
    look.parameters[0].initial = Value(std::vector<double>{1.0, 0.5, 0.0});
    const ShadertoyConstant tint = constants_of(look)[0];
    CHECK(tint.names == std::vector<std::string>{"tint_r", "tint_g", "tint_b"});
    CHECK(tint.text.find("const vec3 tint = vec3(tint_r, tint_g, tint_b);\n") != std::string::npos);
    CHECK(tint.text.find(
              "const float tint_g = 0.5;  // @range 0 1 @label \"Label of tint, green\"") !=
          std::string::npos);
}

TEST_CASE("a condition stays if all its names are constants of the export") {
    Look look;
    look.parameters = {parameter("gain", 0.5), parameter("size", 1.0), parameter("tint", 0.0)};
    look.parameters[0].when = "size > 0";
    look.parameters[1].when = "tint > 0";
    look.parameters[2].type = {Scalar::floating, 2, 1};
    look.parameters[2].initial = Value(std::vector<double>{0.0, 0.0});
    const auto constants = constants_of(look);
    CHECK(read_again(constants[0]).when == "size > 0");
    CHECK(constants[0].is_plain);
    CHECK(read_again(constants[1]).when.empty());
    CHECK_FALSE(constants[1].is_plain);
}
