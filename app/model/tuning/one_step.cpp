#include "model/tuning/one_step.h"

#include "model/tuning/slider_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace {
constexpr double share_of_slider = 0.01;
constexpr double stops_of_color = 0.1;

Result<Value> at_end(const Parameter& parameter, bool up) {
    return fail({{},
                 0,
                 up ? fmt::format("{} is at its maximum", parameter.label)
                    : fmt::format("{} is at its minimum", parameter.label)});
}

Result<Value> next_item(const Parameter& parameter, const Value& value, bool up) {
    const auto& items = parameter.items;
    const auto found = std::ranges::find(items, value.number(), &Item::value);
    const bool is_last = up ? found + 1 >= items.end() : found == items.begin();
    if (found == items.end() || is_last)
        return fail({{},
                     0,
                     up ? fmt::format("{} is at its last item", parameter.label)
                        : fmt::format("{} is at its first item", parameter.label)});
    return Value((up ? found + 1 : found - 1)->value);
}

double next_number(const Parameter& parameter, const Range& range, double number, bool up) {
    const double sign = up ? 1.0 : -1.0;
    if (const double step = step_of(parameter); step > 0.0)
        return std::clamp(number + sign * step, std::min(range.low, number),
                          std::max(range.high, number));
    const double ratio = ratio_in(range, parameter.scale, number);
    return value_at(range, parameter.scale, ratio + sign * share_of_slider);
}

Result<Value> brighter(const Parameter& parameter, const Value& value, bool up) {
    Value next = value;
    for (double& number : next.numbers)
        number *= std::exp2(up ? stops_of_color : -stops_of_color);
    next = clamped(parameter, std::move(next));
    if (next == value)
        return fail({{}, 0, fmt::format("{} is black or at its limit", parameter.label)});
    return next;
}
}  // namespace

Result<Value> one_step(const Parameter& parameter, const Value& value, std::size_t component,
                       bool up) {
    const bool is_turned = parameter.control != Control::event &&
                           parameter.control != Control::image &&
                           parameter.control != Control::sound && parameter.type.columns == 1;
    if (!is_turned || value.numbers.empty())
        return fail({{}, 0, fmt::format("{} can't be changed in steps", parameter.label)});
    if (parameter.control == Control::list)
        return next_item(parameter, value, up);
    if (parameter.control == Control::color)
        return brighter(parameter, value, up);
    constexpr std::size_t upward = 1;  // y of a point
    const std::size_t chosen = parameter.control == Control::point ? upward : component;
    Value next = value;
    double& number = next.numbers[std::min(chosen, next.numbers.size() - 1)];
    if (parameter.type.scalar == Scalar::boolean)
        number = number == 0.0 ? 1.0 : 0.0;
    else
        number = next_number(parameter, range_of(parameter, chosen), number, up);
    next = clamped(parameter, std::move(next));
    if (next == value)
        return at_end(parameter, up);
    return next;
}
