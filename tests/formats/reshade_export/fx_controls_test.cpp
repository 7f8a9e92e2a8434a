#include "formats/reshade_export/fx_controls.h"

#include <doctest/doctest.h>

namespace {
Parameter list_with(std::vector<Item> items) {
    Parameter parameter;
    parameter.name = "mode";
    parameter.label = "Mode";
    parameter.control = Control::list;
    parameter.items = std::move(items);
    return parameter;
}

FxControl control_of(const Parameter& parameter, double value) {
    return fx_control({&parameter, "look_mode", "Mode", Value(value), {0.0, 9.0, 1.0}});
}
}  // namespace

TEST_CASE("the value of a list is the number of its item") {
    const NumberType number;
    const Parameter from_0 = list_with({{0.0, "A"}, {1.0, "B"}});
    CHECK(fx_glsl_value(control_of(from_0, 1.0), number) == "float(look_mode)");
    const Parameter from_minus_1 = list_with({{-1.0, "A"}, {0.0, "B"}, {1.0, "C"}});
    CHECK(fx_glsl_value(control_of(from_minus_1, 1.0), number) == "float((look_mode + -1))");
    CHECK(fx_setting_value(control_of(from_minus_1, 1.0)) == "2");
    const Parameter other = list_with({{0.5, "A"}, {4.0, "B"}, {2.0, "C"}});
    CHECK(fx_glsl_value(control_of(other, 2.0), number) ==
          "float((look_mode == 0 ? 0.5 : (look_mode == 1 ? 4.0 : 2.0)))");
    CHECK(fx_preset_value(control_of(other, 4.0)) == "1");
}

TEST_CASE("a list whose value is no item is a slider") {
    const Parameter list = list_with({{0.0, "A"}, {1.0, "B"}});
    const FxControl control = control_of(list, 0.25);
    CHECK(control.kind == FxControl::Kind::slider);
    CHECK(fx_setting_value(control) == "0.25");
}

TEST_CASE("an item that starts with a digit does not join the zero before it") {
    const Parameter list = list_with({{0.0, "off"}, {1.0, "2x"}});
    const std::string text = fx_declaration(control_of(list, 1.0), Look{});
    CHECK(text.find("ui_items = \"off\\0 2x\\0\";") != std::string::npos);
}

TEST_CASE("vkBasalt gets no vectors, because it reads one number") {
    Parameter tint;
    tint.type = {Scalar::floating, 3, 1};
    tint.control = Control::color;
    const FxControl control =
        fx_control({&tint, "look_tint", "Tint", Value(std::vector{1.0, 0.5, 0.25}), {}});
    CHECK(control.kind == FxControl::Kind::color);
    CHECK(fx_setting_value(control).empty());
    CHECK(fx_preset_value(control) == "1,0.5,0.25");
}
