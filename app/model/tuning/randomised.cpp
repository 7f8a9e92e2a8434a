#include "model/tuning/randomised.h"

#include "model/look/color.h"
#include "model/tuning/random_numbers.h"
#include "model/tuning/slider_range.h"

#include <algorithm>
#include <cmath>

namespace {
bool counts_work(const Look& look, const std::string& name) {
    return std::ranges::any_of(look.passes, [&](const Pass& pass) {
        return pass.repeat == Count(name) || pass.converge == Count(name);
    });
}

double rolled_number(const Parameter& parameter, Range range, double origin,
                     RandomNumbers& random_numbers) {
    range.step = step_of(parameter);
    const auto steps = steps_in(range, origin);
    if (steps && parameter.scale == Scale::linear)
        return steps->value(random_numbers.choose(steps->count));
    const double value = value_at(range, parameter.scale, random_numbers.next());
    return steps ? steps->nearest(value) : readable(range, parameter.scale, value);
}

Value rolled_color(const Parameter& parameter, Value value, RandomNumbers& random_numbers) {
    constexpr std::size_t alpha = 3;
    const Range& range = parameter.range;
    for (std::size_t i = 0; i < std::min(value.numbers.size(), alpha); ++i)
        value.numbers[i] =
            range.low + (range.high - range.low) * srgb_decode(random_numbers.next());
    return value;
}

Value rolled(const Parameter& parameter, double origin, Value value,
             RandomNumbers& random_numbers) {
    if (parameter.control == Control::color)
        return rolled_color(parameter, std::move(value), random_numbers);
    if (parameter.control == Control::list)
        return Value(parameter
                         .items[static_cast<std::size_t>(
                             random_numbers.choose(static_cast<double>(parameter.items.size())))]
                         .value);
    for (std::size_t i = 0; i < value.numbers.size(); ++i)
        value.numbers[i] =
            parameter.type.scalar == Scalar::boolean
                ? random_numbers.choose(2.0)
                : rolled_number(parameter, range_of(parameter, i), origin, random_numbers);
    return value;
}
}  // namespace

bool is_randomised(const Look& look, const Parameter& parameter) {
    if (parameter.is_hidden || parameter.orbit != OrbitPart::none || parameter.type.columns > 1 ||
        counts_work(look, parameter.name))
        return false;
    switch (parameter.control) {
        case Control::list:
            return !parameter.items.empty();
        case Control::event:
        case Control::image:
        case Control::sound:
            return false;
        case Control::slider:
        case Control::angle:
        case Control::point:
        case Control::color:
            break;
    }
    return parameter.type.scalar == Scalar::boolean || parameter.range.low < parameter.range.high;
}

Values randomised_values(const Look& look, const Values& values, const ParameterSettings& settings,
                         std::uint64_t seed) {
    Values next = values;
    for (const Parameter& parameter : look.parameters) {
        const ParameterSetting& setting = setting_of(parameter.name, settings);
        if (setting.is_locked || !is_randomised(look, parameter))
            continue;
        RandomNumbers random_numbers(seed ^ digest_of(parameter.name));
        next[parameter.name] =
            clamped(parameter, rolled(with_ends(parameter, setting), parameter.range.low,
                                      value_of(parameter, values), random_numbers));
    }
    return next;
}
