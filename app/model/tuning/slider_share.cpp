#include "model/tuning/slider_share.h"

#include "model/tuning/slider_range.h"

#include <algorithm>
#include <cmath>

namespace {
bool is_switch(const Parameter& parameter) {
    return parameter.type.scalar == Scalar::boolean || parameter.control == Control::event;
}

double number_at(const SliderNumber& at, double share) {
    const Parameter& parameter = at.parameter;
    if (parameter.control == Control::list) {
        const auto count = static_cast<double>(parameter.items.size());
        const double item = std::min(std::floor(share * count), count - 1.0);
        return parameter.items[static_cast<std::size_t>(item)].value;
    }
    if (is_switch(parameter))
        return share >= 0.5 ? 1.0 : 0.0;
    Range range = range_of(with_ends(parameter, at.setting), at.component);
    range.step = step_of(parameter);
    const double value = value_at(range, parameter.scale, share);
    const auto steps = steps_in(range, parameter.range.low);
    return steps ? steps->nearest(value) : value;
}
}  // namespace

bool has_slider_numbers(const Parameter& parameter) {
    const bool is_other = parameter.control == Control::image ||
                          parameter.control == Control::sound ||
                          parameter.control == Control::color || parameter.type.columns > 1;
    return !is_other && !(parameter.control == Control::list && parameter.items.empty());
}

bool is_gradual(const Parameter& parameter) {
    return !is_switch(parameter) && parameter.control != Control::list;
}

Value value_at_share(const SliderNumber& at, Value current, double share) {
    if (at.component < current.numbers.size())
        current.numbers[at.component] = number_at(at, std::clamp(share, 0.0, 1.0));
    return clamped(at.parameter, std::move(current));
}

double share_at(const SliderNumber& at, const Value& value) {
    const Parameter& parameter = at.parameter;
    const double number = at.component < value.numbers.size() ? value.numbers[at.component] : 0.0;
    if (parameter.control == Control::list) {
        const auto item = std::ranges::find(parameter.items, number, &Item::value);
        const auto index = static_cast<double>(item - parameter.items.begin());
        return std::min((index + 0.5) / static_cast<double>(parameter.items.size()), 1.0);
    }
    if (is_switch(parameter))
        return number >= 0.5 ? 1.0 : 0.0;
    const Range range = range_of(with_ends(parameter, at.setting), at.component);
    return std::clamp(ratio_in(range, parameter.scale, number), 0.0, 1.0);
}
