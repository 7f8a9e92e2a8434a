#include "formats/reshade_export/fx_controls.h"

#include "base/text.h"
#include "formats/reshade_export/fx_text.h"
#include "glsl/constants/constants.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
using Kind = FxControl::Kind;

// The index of the item with the present value; nullopt if there is none.
std::optional<std::size_t> item_index(const EffectControl& control) {
    const std::vector<Item>& items = control.parameter->items;
    const auto found = std::ranges::find(items, control.value.number(), &Item::value);
    return found == items.end() ? std::nullopt
                                : std::optional(static_cast<std::size_t>(found - items.begin()));
}

Kind kind_of(const EffectControl& control) {
    const Parameter& parameter = *control.parameter;
    if (parameter.type.scalar == Scalar::boolean)
        return Kind::checkbox;
    if (parameter.type.size() == 1 && parameter.control == Control::list && item_index(control))
        return Kind::combo;
    constexpr int channels = 3;
    if (parameter.control == Control::color && parameter.type.size() == channels)
        return Kind::color;
    return Kind::slider;
}

// As the uniform has it.
std::vector<double> numbers_of(const FxControl& control) {
    if (control.kind == Kind::combo)
        return {static_cast<double>(item_index(control.control).value_or(0))};
    return control.control.value.numbers;
}

// Labels of items are separated by zeros. A digit after one would belong to it.
std::string items_text(const std::vector<Item>& items) {
    std::string text;
    for (const Item& item : items) {
        const std::string quoted = fx_string(item.label);
        const bool has_digit = item.label[0] >= '0' && item.label[0] <= '9';
        text += has_digit ? " " : "";
        text += quoted.substr(1, quoted.size() - 2) + "\\0";
    }
    return "\"" + text + "\"";
}

std::string range_text(const FxControl& control) {
    NumberType component = control.type;
    component.rows = 1;
    const Range& range = control.control.range;
    return fmt::format(" ui_type = \"slider\"; ui_min = {}; ui_max = {}; ui_step = {};",
                       glsl_number(component, range.low), glsl_number(component, range.high),
                       component.scalar == Scalar::floating
                           ? glsl_number(component, range.step)
                           : glsl_number(component, std::max(1.0, range.step)));
}

// The item's number for the index of a combo.
std::string item_value(const FxControl& control) {
    const std::vector<Item>& items = control.control.parameter->items;
    const std::string& id = control.control.id;
    bool is_consecutive = true;
    for (std::size_t i = 0; i < items.size(); ++i)
        is_consecutive =
            is_consecutive && items[i].value == items[0].value + static_cast<double>(i);
    if (is_consecutive)
        return items[0].value == 0.0 ? id : fmt::format("({} + {:.0f})", id, items[0].value);
    std::string value = glsl_number({}, items.back().value);
    for (std::size_t i = items.size() - 1; i-- > 0;)
        value = fmt::format("({} == {} ? {} : {})", id, i, glsl_number({}, items[i].value), value);
    return value;
}
}  // namespace

bool fits_fx(const Parameter& parameter) {
    return parameter.type.columns == 1 &&
           (parameter.type.rows == 1 || parameter.type.scalar != Scalar::boolean);
}

FxControl fx_control(EffectControl control) {
    FxControl made;
    made.kind = kind_of(control);
    made.type =
        made.kind == Kind::combo ? NumberType{Scalar::integer, 1, 1} : control.parameter->type;
    made.control = std::move(control);
    return made;
}

std::string hlsl_name(const NumberType& type) {
    const char* const scalar = type.scalar == Scalar::floating  ? "float"
                               : type.scalar == Scalar::integer ? "int"
                               : type.scalar == Scalar::boolean ? "bool"
                                                                : "uint";
    return type.rows == 1 ? scalar : fmt::format("{}{}", scalar, type.rows);
}

std::string fx_declaration(const FxControl& control, const Look& look) {
    const Parameter& parameter = *control.control.parameter;
    std::string text = fmt::format("uniform {} {} <", hlsl_name(control.type), control.control.id);
    const std::string unit = parameter.unit.empty() ? "" : fmt::format(" ({})", parameter.unit);
    text += fmt::format(" ui_label = {};", fx_string(parameter.label + unit));
    if (const std::string heading = heading_of(look, parameter); !heading.empty())
        text += fmt::format(" ui_category = {};", fx_string(heading));
    if (!parameter.help.empty())
        text += fmt::format(" ui_tooltip = {};", fx_string(parameter.help));
    if (control.kind == Kind::combo)
        text += fmt::format(" ui_type = \"combo\"; ui_items = {};", items_text(parameter.items));
    else if (control.kind == Kind::color)
        text += " ui_type = \"color\";";
    else if (control.kind == Kind::slider)
        text += range_text(control);
    NumberType component = control.type;
    component.rows = 1;
    std::string value;
    for (const double number : numbers_of(control))
        value += (value.empty() ? "" : ", ") + glsl_number(component, number);
    if (control.type.rows > 1)
        value = fmt::format("{}({})", hlsl_name(control.type), value);
    return fmt::format("{} > = {};\n", text, value);
}

std::string fx_glsl_value(const FxControl& control, const NumberType& type) {
    if (control.kind == Kind::combo)
        return fmt::format("{}({})", glsl_name(type), item_value(control));
    return control.type == type ? control.control.id
                                : fmt::format("{}({})", glsl_name(type), control.control.id);
}

std::string fx_preset_value(const FxControl& control) {
    std::string text;
    for (const double number : numbers_of(control))
        text += (text.empty() ? "" : ",") + format_float(static_cast<float>(number));
    return text;
}

std::string fx_setting_value(const FxControl& control) {
    if (control.type.rows > 1)
        return {};
    if (control.kind == Kind::checkbox)
        return control.control.value.number() != 0.0 ? "true" : "false";
    return fx_preset_value(control);
}
