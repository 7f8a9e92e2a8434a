#include "model/tuning/trial_values.h"

#include "model/tuning/one_step.h"

#include <algorithm>
#include <utility>

namespace {
bool has_trial_values(const Parameter& parameter, const Value& value) {
    return parameter.control != Control::event && parameter.control != Control::image &&
           parameter.control != Control::sound && parameter.type.columns == 1 &&
           !value.numbers.empty();
}

// All components at one end of their slider.
Value at_end(const Parameter& parameter, Value value, bool high) {
    for (std::size_t i = 0; i < value.numbers.size(); ++i) {
        const Range& range = range_of(parameter, i);
        value.numbers[i] = high ? range.high : range.low;
    }
    return clamped(parameter, std::move(value));
}
}  // namespace

std::vector<Value> trial_values(const Parameter& parameter, const Value& value) {
    if (!has_trial_values(parameter, value))
        return {};
    std::vector<Value> found;
    const auto add = [&](const Value& trial) {
        if (trial != value && std::ranges::find(found, trial) == found.end())
            found.push_back(trial);
    };
    if (parameter.control == Control::list) {
        for (const Item& item : parameter.items)
            add(Value(item.value));
        return found;
    }
    for (const bool up : {true, false})
        if (const auto next = one_step(parameter, value, 0, up); next && found.empty())
            add(*next);
    add(at_end(parameter, value, true));
    add(at_end(parameter, value, false));
    return found;
}
