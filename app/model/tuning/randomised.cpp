#include "model/tuning/randomised.h"

#include "model/look/color.h"
#include "model/tuning/random_numbers.h"
#include "model/tuning/slider_range.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace {
bool counts_work(const Look& look, const std::string& name) {
    return look.subframes == Count(name) || std::ranges::any_of(look.passes, [&](const Pass& pass) {
               return pass.repeat == Count(name) || pass.converge == Count(name);
           });
}

double mixed(double from, double to, double share) {
    return share >= 1.0 ? to : from + (to - from) * share;
}

// The random values of one parameter.
class Roll {
public:
    Roll(const Parameter& parameter, double origin, const RandomChange& change)
        : m_parameter(parameter),
          m_origin(origin),
          m_strength(change.strength),
          m_numbers(change.seed ^ digest_of(parameter.name)) {}

    Value value(Value current) {
        if (m_parameter.control == Control::color)
            return color(std::move(current));
        if (m_parameter.control == Control::list)
            return item(std::move(current));
        for (std::size_t i = 0; i < current.numbers.size(); ++i)
            current.numbers[i] = m_parameter.type.scalar == Scalar::boolean
                                     ? switched(current.numbers[i])
                                     : number(range_of(m_parameter, i), current.numbers[i]);
        return current;
    }

private:
    // Whether a value without intermediate ones changes.
    bool is_changed() { return m_strength >= 1.0 || m_numbers.next() < m_strength; }

    double switched(double current) {
        const double next = m_numbers.choose(2.0);
        return is_changed() ? next : current;
    }

    Value item(Value current) {
        const auto index = static_cast<std::size_t>(
            m_numbers.choose(static_cast<double>(m_parameter.items.size())));
        return is_changed() ? Value(m_parameter.items[index].value) : std::move(current);
    }

    double number(Range range, double current) {
        range.step = step_of(m_parameter);
        const Scale scale = m_parameter.scale;
        const auto steps = steps_in(range, m_origin);
        if (steps && scale == Scale::linear && m_strength >= 1.0)
            return steps->value(m_numbers.choose(steps->count));
        const double ratio = mixed(ratio_in(range, scale, current), m_numbers.next(), m_strength);
        const double value = value_at(range, scale, ratio);
        return steps ? steps->nearest(value) : readable(range, scale, value);
    }

    Value color(Value value) {
        constexpr std::size_t alpha = 3;
        const Range& range = m_parameter.range;
        const double span = range.high - range.low;
        for (std::size_t i = 0; i < std::min(value.numbers.size(), alpha); ++i) {
            const double current =
                srgb_encode(std::clamp((value.numbers[i] - range.low) / span, 0.0, 1.0));
            value.numbers[i] =
                range.low + span * srgb_decode(mixed(current, m_numbers.next(), m_strength));
        }
        return value;
    }

    const Parameter& m_parameter;
    double m_origin;  // of the steps
    double m_strength;
    RandomNumbers m_numbers;
};
}  // namespace

bool is_randomised(const Look& look, const Parameter& parameter) {
    if (parameter.is_hidden || parameter.is_fixed_in_random || parameter.orbit != OrbitPart::none ||
        parameter.type.columns > 1 || counts_work(look, parameter.name))
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
                         const RandomChange& change) {
    Values next = values;
    for (const Parameter& parameter : look.parameters) {
        const ParameterSetting& setting = setting_of(parameter.name, settings);
        const bool is_chosen =
            change.names.empty() ||
            std::ranges::find(change.names, parameter.name) != change.names.end();
        if (!is_chosen || setting.is_locked || !is_randomised(look, parameter))
            continue;
        const Parameter limited = with_ends(parameter, setting);
        next[parameter.name] =
            clamped(parameter,
                    Roll(limited, parameter.range.low, change).value(value_of(parameter, values)));
    }
    return next;
}
