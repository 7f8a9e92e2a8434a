#include "model/picture/aliasing.h"

#include "model/look/value_text.h"
#include "model/plan/expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace {
// The name prefix of the parameter's look.
std::string name_prefix(const Parameter& parameter, const Look& look) {
    if (parameter.bindings.empty())
        return {};
    return look.passes.at(static_cast<std::size_t>(parameter.bindings.front().pass)).scope;
}

std::map<std::string, double> names_for(const std::string& scope,
                                        const std::vector<Parameter>& parameters,
                                        const PeriodTerms& terms) {
    std::map<std::string, double> names{{"WIDTH", terms.target.width},
                                        {"HEIGHT", terms.target.height},
                                        {"LINE", terms.raster.rows.pitch * terms.target.height},
                                        {"LINES", terms.raster.rows.count},
                                        {"COLUMN", terms.raster.columns.pitch * terms.target.width},
                                        {"COLUMNS", terms.raster.columns.count}};
    for (const Parameter& parameter : parameters)
        if (parameter.name.starts_with(scope) && parameter.type.size() == 1)
            names[parameter.name.substr(scope.size())] = value_of(parameter, terms.values).number();
    return names;
}

// Evaluates a parameter's period at several values.
class PeriodReader {
public:
    PeriodReader(const Parameter& parameter, const PeriodTerms& terms) : m_parameter(parameter) {
        if (parameter.period.empty())
            return;
        const std::string scope = name_prefix(parameter, terms.look);
        m_names = names_for(scope, terms.look.parameters, terms);
        m_name = parameter.name.substr(scope.size());
    }

    // 0 without a period.
    double at(double value) {
        if (m_parameter.period.empty())
            return is_period(m_parameter) ? value : 0.0;
        m_names[m_name] = value;
        return std::max(evaluate(m_parameter.period, m_names).value_or(0.0), 0.0);
    }

private:
    const Parameter& m_parameter;
    std::map<std::string, double> m_names;
    std::string m_name;
};
}  // namespace

std::optional<double> period_of(const Parameter& parameter, double value,
                                const PeriodTerms& terms) {
    const double period = PeriodReader(parameter, terms).at(value);
    return period > 0.0 ? std::optional(period) : std::nullopt;
}

std::optional<double> whole_period_value(const Parameter& parameter, double value,
                                         const PeriodTerms& terms) {
    constexpr int halvings = 60;
    PeriodReader reader(parameter, terms);
    const double wanted = std::max(2.0, std::round(reader.at(value)));
    double low = parameter.range.low;
    double high = parameter.range.high;
    const bool grows = reader.at(high) > reader.at(low);
    const auto is_below = [&](double at) { return (reader.at(at) < wanted) == grows; };
    if (!is_below(low) && reader.at(low) != wanted)
        return std::nullopt;
    for (int i = 0; i < halvings; ++i)
        (is_below(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
    constexpr double near = 1e-6;
    return std::abs(reader.at(high) - wanted) < near ? std::optional(high) : std::nullopt;
}

Diagnostics check_periods(const std::vector<Parameter>& parameters, const Look& look) {
    Diagnostics problems;
    const Values none;
    const PeriodTerms terms{look, none, {1, 1}, {}};
    for (const Parameter& parameter : parameters) {
        if (parameter.period.empty())
            continue;
        const auto period =
            evaluate(parameter.period, names_for(name_prefix(parameter, look), parameters, terms));
        if (!period)
            problems.push_back(
                {parameter.declared.file, parameter.declared.line,
                 fmt::format("@period of '{}': {}", parameter.name, period.error()[0].message)});
    }
    return problems;
}

double beat_of(double period) {
    const double whole = std::max(1.0, std::round(period));
    const double drift = std::abs(1.0 / period - 1.0 / whole);
    constexpr double exact = 1e-9;
    return drift < exact ? std::numeric_limits<double>::infinity() : 1.0 / drift;
}

double unevenness_of(double period) {
    return period <= 2.0 ? 1.0 : 1.0 - std::cos(std::numbers::pi / period);
}

std::optional<double> visible_beat(double period, double length) {
    constexpr double min_visible = 0.05;
    if (!(period > 0.0) || unevenness_of(period) < min_visible)
        return std::nullopt;
    const double beat = beat_of(period);
    return beat <= length ? std::optional(beat) : std::nullopt;
}

std::vector<double> safe_periods(double low, double high) {
    constexpr double maximum = 1000.0;
    std::vector<double> periods;
    for (double p = std::max(2.0, std::ceil(low)); p <= std::min(high, maximum); p += 1.0)
        periods.push_back(p);
    return periods;
}
