#include "lab/offline/sweep.h"

#include "base/text.h"
#include "lab/document/naming.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace {
constexpr int max_stops = 100;

std::string unit_of(const Parameter& parameter) {
    const std::string unit = parameter.control == Control::angle ? "rad" : parameter.unit;
    return unit.empty() ? unit : ' ' + unit;
}

bool is_single_number(const Parameter& parameter) {
    const bool is_file = parameter.control == Control::image || parameter.control == Control::sound;
    return !is_file && parameter.control != Control::event && parameter.type.size() == 1;
}

// The value at a relative slider position, 0..1, between `low` and `high`.
double value_between(const Parameter& parameter, double low, double high, double share) {
    const bool is_ratio = parameter.scale == Scale::logarithmic && low > 0.0 && high > 0.0;
    const double value = is_ratio ? low * std::pow(high / low, share) : low + (high - low) * share;
    return parameter.type.scalar == Scalar::floating ? value : std::round(value);
}

// Converts "0.5:0.99:5" to texts of values; fails for other forms.
Result<std::vector<std::string>> texts_of_span(const Parameter& parameter, std::string_view text) {
    const auto parts = split(text, ':');
    const auto low = parse_number(trim(parts[0]));
    const auto high = parts.size() == 3 ? parse_number(trim(parts[1])) : std::nullopt;
    const int count = parts.size() == 3 ? parse_integer(trim(parts[2])).value_or(0) : 0;
    if (!low || !high || count < 2 || count > max_stops)
        return fail(
            {{},
             0,
             fmt::format("expected name=low:high:count with a count from 2 to {}, got '{}={}'",
                         max_stops, parameter.name, text)});
    std::vector<std::string> texts;
    for (int i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / (count - 1);
        const std::string next = fmt::format("{}", value_between(parameter, *low, *high, share));
        if (texts.empty() || texts.back() != next)  // rounded numbers can coincide
            texts.push_back(next);
    }
    return texts;
}

Result<std::vector<std::string>> texts_of(const Parameter& parameter, std::string_view text) {
    if (text.find(':') != std::string_view::npos)
        return texts_of_span(parameter, text);
    std::vector<std::string> texts;
    for (const std::string_view piece : split(text, ','))
        texts.emplace_back(trim(piece));
    if (texts.size() > static_cast<std::size_t>(max_stops))
        return fail({{},
                     0,
                     fmt::format("'{}' has {} values; the limit is {}", parameter.name,
                                 texts.size(), max_stops)});
    return texts;
}

std::string caption_of(const Parameter& parameter, const Value& value) {
    for (const Item& item : parameter.items)
        if (item.value == value.number())
            return fmt::format("{}: {}", parameter.label, item.label);
    if (parameter.type.scalar == Scalar::boolean)
        return value.number() != 0.0 ? fmt::format("{}: on", parameter.label)
                                     : fmt::format("{}: off", parameter.label);
    return fmt::format("{} {:.4g}{}", parameter.label, value.number(), unit_of(parameter));
}
}  // namespace

Result<SweepAxis> parse_sweep_axis(std::string_view text, const Look& look) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0)
        return fail(
            {{}, 0, fmt::format("expected name=low:high:count or name=a,b,c, got '{}'", text)});
    const auto parameter = resolve_parameter(std::string(text.substr(0, equals)), look);
    if (!parameter)
        return fail(parameter.error());
    if (!is_single_number(**parameter))
        return fail(
            {{},
             0,
             fmt::format("'{}' is not a single number and can't be swept", (*parameter)->name)});
    const auto texts = texts_of(**parameter, text.substr(equals + 1));
    if (!texts)
        return fail(texts.error());
    SweepAxis axis{(*parameter)->name, {}};
    for (const std::string& one : *texts) {
        auto value = parse_value(**parameter, one);
        if (!value)
            return fail(value.error());
        std::string caption = caption_of(**parameter, *value);
        axis.stops.push_back({std::move(*value), std::move(caption)});
    }
    return axis;
}

std::vector<SweepCell> sweep_cells(const std::vector<SweepAxis>& axes) {
    std::vector<SweepCell> cells{SweepCell{}};
    for (const SweepAxis& axis : axes) {
        std::vector<SweepCell> more;
        for (const SweepAxis::Stop& stop : axis.stops)
            for (const SweepCell& cell : cells) {
                SweepCell next = cell;
                next.values.emplace_back(axis.parameter, stop.value);
                next.caption += (cell.caption.empty() ? "" : ", ") + stop.caption;
                more.push_back(std::move(next));
            }
        cells = std::move(more);
    }
    return cells;
}

int sheet_columns(const std::vector<SweepAxis>& axes, int with_one_axis) {
    return axes.size() > 1 ? static_cast<int>(axes[0].stops.size()) : with_one_axis;
}
