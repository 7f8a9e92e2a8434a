#include "model/tuning/parameter_settings.h"

#include "base/text.h"
#include "model/look/renamed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

const ParameterSetting& setting_of(const std::string& name, const ParameterSettings& settings) {
    static const ParameterSetting none;
    const auto found = settings.find(name);
    return found == settings.end() ? none : found->second;
}

ParameterSettings renamed_settings(const Look& look, ParameterSettings settings) {
    return renamed(look, std::move(settings));
}

Parameter with_ends(Parameter parameter, const ParameterSetting& setting) {
    if (setting.ends && has_ends(parameter))
        if (const auto ends = fitted_ends(parameter, *setting.ends)) {
            parameter.range.low = ends->low;
            parameter.range.high = ends->high;
            parameter.axes.clear();
        }
    return parameter;
}

Result<Limit> fitted_ends(const Parameter& parameter, Limit ends) {
    const auto fitted = [&](double end) {
        if (parameter.limit)
            end = std::clamp(end, parameter.limit->low, parameter.limit->high);
        return parameter.type.scalar == Scalar::floating ? end : std::round(end);
    };
    const Limit inside{fitted(ends.low), fitted(ends.high)};
    if (!(inside.low < inside.high) || !std::isfinite(inside.high - inside.low))
        return fail(
            {{},
             0,
             fmt::format("the slider minimum of '{}' must be below its maximum, got {} "
                         "and {}",
                         parameter.label, format_number(ends.low), format_number(ends.high))});
    return inside;
}

bool has_ends(const Parameter& parameter) {
    const bool is_turned = parameter.control == Control::slider ||
                           parameter.control == Control::angle ||
                           parameter.control == Control::point;
    return is_turned && parameter.type.scalar != Scalar::boolean && parameter.type.columns == 1;
}

ParameterSettings settings_in(const Stack& stack, const LookParameterSettings& looks) {
    ParameterSettings settings;
    for (std::size_t i = 0; i < stack.size(); ++i)
        if (const auto own = looks.find(stack[i].look); own != looks.end())
            for (const auto& [name, setting] : own->second)
                settings.emplace(name_prefix(stack, i) + name, setting);
    return settings;
}

void store_settings(LookParameterSettings& looks, const Stack& stack,
                    const ParameterSettings& settings) {
    for (std::size_t i = stack.size(); i-- > 0;) {
        const std::string scope = name_prefix(stack, i);
        ParameterSettings own;
        for (const auto& [name, setting] : settings)
            if (name.starts_with(scope))
                own.emplace(name.substr(scope.size()), setting);
        if (own.empty())
            looks.erase(stack[i].look);
        else
            looks[stack[i].look] = std::move(own);
    }
}
