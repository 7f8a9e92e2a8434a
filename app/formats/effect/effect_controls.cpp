#include "formats/effect/effect_controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace {
// The step of a range without one: 1, 2 or 5 times a power of 10, about 200 over the range.
double usual_step(const Range& range) {
    constexpr double steps = 200.0;
    const double step = (range.high - range.low) / steps;
    if (step <= 0.0)
        return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(step)));
    const double digit = step / power;
    return power * (digit < 1.5 ? 1.0 : digit < 3.5 ? 2.0 : digit < 7.5 ? 5.0 : 10.0);
}

std::string label_of(const Parameter& parameter) {
    const std::string& group = parameter.group;
    std::string label = group.empty() ? parameter.label : group + ": " + parameter.label;
    if (!parameter.unit.empty())
        label += fmt::format(" ({})", parameter.unit);
    return quotable(label);
}

Range range_with(const Parameter& parameter, const Value& value) {
    Range range = parameter.range;
    if (parameter.control == Control::list && !parameter.items.empty()) {
        const auto [low, high] = std::ranges::minmax_element(parameter.items, {}, &Item::value);
        range = {low->value, high->value, 1.0};
    }
    const bool is_whole = parameter.type.scalar != Scalar::floating;
    if (parameter.type.scalar == Scalar::boolean)
        range = {0.0, 1.0, 1.0};
    for (const double number : value.numbers) {
        range.low = std::min(range.low, number);
        range.high = std::max(range.high, number);
    }
    if (range.step <= 0.0)
        range.step = is_whole ? 1.0 : usual_step(range);
    return range;
}

bool is_adjustable(const Parameter& parameter, const std::vector<std::string>& fixed) {
    const bool is_number = parameter.control != Control::image &&
                           parameter.control != Control::sound &&
                           parameter.control != Control::event;
    return is_number && !parameter.is_constant && !parameter.bindings.empty() &&
           std::ranges::find(fixed, parameter.name) == fixed.end();
}
}  // namespace

std::vector<EffectControl> effect_controls(const Look& look, const Values& values,
                                           const std::vector<std::string>& fixed,
                                           EffectNames& names) {
    std::vector<EffectControl> controls;
    for (const Parameter& parameter : look.parameters) {
        if (!is_adjustable(parameter, fixed))
            continue;
        Value value = value_for_shaders(parameter, value_of(parameter, values));
        Range range = range_with(parameter, value);
        controls.push_back(
            {&parameter, names.add(parameter.name), label_of(parameter), std::move(value), range});
    }
    return controls;
}

std::string quotable(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
        safe += c == '"' ? '\'' : (is_control || c == '\\' ? ' ' : c);
    }
    return safe;
}
