#include "formats/isf_export/isf_inputs.h"

#include "model/look/color.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

using Json = nlohmann::ordered_json;

namespace {
bool is_color(const Parameter& parameter) {
    return parameter.control == Control::color && parameter.type.scalar == Scalar::floating;
}

bool is_point(const Parameter& parameter) {
    return parameter.type == NumberType{Scalar::floating, 2, 1};
}

// The host's color input has components from 0 to 1.
bool fits_color(const EffectControl& control) {
    return is_color(*control.parameter) && std::ranges::all_of(control.value.numbers, [](double x) {
               return x >= 0.0 && x <= 1.0;
           });
}

Json color_input(const EffectControl& control, const std::string& name) {
    std::vector<double> numbers = control.value.numbers;
    if (control.parameter->encoding == Encoding::linear)
        for (std::size_t i = 0; i < std::min<std::size_t>(numbers.size(), 3); ++i)
            numbers[i] = srgb_encode(numbers[i]);
    numbers.resize(4, 1.0);
    return {{"NAME", name}, {"LABEL", control.label}, {"TYPE", "color"}, {"DEFAULT", numbers}};
}

Json point_input(const EffectControl& control, const std::string& name) {
    const Range& range = control.range;
    return {{"NAME", name},
            {"LABEL", control.label},
            {"TYPE", "point2D"},
            {"MIN", {range.low, range.low}},
            {"MAX", {range.high, range.high}},
            {"DEFAULT", control.value.numbers}};
}

Json number_input(const EffectControl& control, std::size_t part, const std::string& name) {
    const Parameter& parameter = *control.parameter;
    std::string label = control.label;
    if (control.value.numbers.size() > 1)
        label += ", " + component_label(parameter, part);
    Json json{{"NAME", name}, {"LABEL", label}};
    const double value = control.value.numbers[part];
    if (parameter.type.scalar == Scalar::boolean) {
        json["TYPE"] = "bool";
        json["DEFAULT"] = value != 0.0;
        return json;
    }
    const bool is_whole = parameter.type.scalar != Scalar::floating;
    json["TYPE"] = is_whole ? "long" : "float";
    if (is_whole && !parameter.items.empty()) {
        for (const Item& item : parameter.items) {
            json["VALUES"].push_back(static_cast<int>(item.value));
            json["LABELS"].push_back(item.label);
        }
    } else {
        json["MIN"] = control.range.low;
        json["MAX"] = control.range.high;
    }
    if (is_whole)
        json["DEFAULT"] = static_cast<int>(value);
    else
        json["DEFAULT"] = value;
    return json;
}
}  // namespace

std::vector<IsfControl> isf_controls(std::vector<EffectControl> controls, EffectNames& names) {
    std::vector<IsfControl> all;
    for (EffectControl& control : controls) {
        const Parameter& parameter = *control.parameter;
        const std::size_t count = control.value.numbers.size();
        IsfControl one{std::move(control), {}, false};
        if (fits_color(one.control)) {
            one.names = {names.add(one.control.id + "_display")};
        } else if (count == 1 || is_point(parameter)) {
            one.names = {one.control.id};
            one.is_direct = parameter.type.scalar != Scalar::unsigned_integer;
        } else {
            for (std::size_t i = 0; i < count; ++i)
                one.names.push_back(
                    names.add(one.control.id + "_" + component_label(parameter, i)));
        }
        all.push_back(std::move(one));
    }
    return all;
}

Json isf_inputs(const IsfControl& control) {
    Json inputs = Json::array();
    for (std::size_t i = 0; i < control.names.size(); ++i) {
        if (fits_color(control.control))
            inputs.push_back(color_input(control.control, control.names[i]));
        else if (is_point(*control.control.parameter))
            inputs.push_back(point_input(control.control, control.names[i]));
        else
            inputs.push_back(number_input(control.control, i, control.names[i]));
    }
    return inputs;
}

std::string isf_value(const IsfControl& control, const NumberType& type) {
    const Parameter& parameter = *control.control.parameter;
    if (fits_color(control.control)) {
        const bool is_linear = parameter.encoding == Encoding::linear;
        const std::string& name = control.names.front();
        const std::string color = is_linear ? "display_to_linear(" + name + ")" : name;
        return type.size() == 4 ? color : color + ".rgb";
    }
    std::string parts;
    for (const std::string& name : control.names)
        parts += (parts.empty() ? "" : ", ") + name;
    return control.is_direct ? parts : fmt::format("{}({})", glsl_name(type), parts);
}
