#include "lab/document/automation_file.h"

#include "base/file.h"
#include "base/text.h"
#include "lab/document/naming.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace {
// Removes the first word of a line and returns it.
std::string_view take_word(std::string_view& line) {
    line = trim(line);
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    const std::string_view word = line.substr(0, end);
    line = trim(line.substr(end));
    return word;
}

Result<const Parameter*> recorded_parameter(std::string_view name, const Look& look) {
    auto parameter = resolve_parameter(std::string(name), look);
    if (parameter && !is_recorded(**parameter))
        return fail({{}, 0, fmt::format("'{}' is a file and can't be automated", name)});
    return parameter;
}

Result<AutomationPoint> parse_point(std::string_view line, const Look& look, double earliest) {
    const std::string_view time = take_word(line);
    const std::string_view name = take_word(line);
    const auto seconds = parse_number(time);
    if (!seconds || !(*seconds >= 0.0) || name.empty() || line.empty())
        return fail({{}, 0, "expected 'seconds name value'"});
    if (*seconds < earliest)
        return fail({{},
                     0,
                     fmt::format("{} s is earlier than {} s on the line above",
                                 format_number(*seconds), format_number(earliest))});
    const auto parameter = recorded_parameter(name, look);
    if (!parameter)
        return fail(parameter.error());
    auto value = parse_value(**parameter, line);
    if (!value)
        return fail(value.error());
    return AutomationPoint{*seconds, (*parameter)->name, std::move(*value)};
}

// The value as the user would type it.
std::string typed_text(const Parameter& parameter, const Value& value) {
    for (const Item& item : parameter.items)
        if (value == Value(item.value))
            return item.label;
    if (parameter.type == NumberType{Scalar::boolean})
        return value.number() != 0.0 ? "true" : "false";
    return to_string(value);
}
}  // namespace

Result<AutomationPoints> parse_automation(std::string_view text, const std::filesystem::path& file,
                                          const Look& look) {
    AutomationPoints points;
    Diagnostics problems;
    double earliest = 0.0;
    int number = 0;
    for (const std::string_view line : split(text, '\n')) {
        ++number;
        if (trim(line).empty() || trim(line).front() == '#')
            continue;
        auto point = parse_point(line, look, earliest);
        if (!point) {
            problems.push_back({file, number, point.error().front().message});
            continue;
        }
        earliest = point->seconds;
        points.push_back(std::move(*point));
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return points;
}

Result<AutomationPoints> load_automation(const std::filesystem::path& file, const Look& look) {
    const auto text = read_text(file);
    return text ? parse_automation(*text, file, look) : fail(text.error());
}

std::string automation_text(const AutomationPoints& points, const Look& look) {
    std::string text = fmt::format("# Automation of {}: seconds name value\n", look.id);
    for (const AutomationPoint& point : points)
        if (const Parameter* parameter = find_parameter(look, point.name))
            text += fmt::format("{:.6f} {} {}\n", point.seconds, point.name,
                                typed_text(*parameter, point.value));
    return text;
}
