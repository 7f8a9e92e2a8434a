#include "ui/typed_number.h"

#include "base/text.h"
#include "model/decay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace {
// "1,000" and "12,345": a comma between thousands, or before three decimals.
bool is_ambiguous(std::string_view text) {
    const auto comma = text.find(',');
    const auto first = text.find_first_of("123456789");
    return text.size() == comma + 4 && first < comma;
}

std::optional<double> number_in(std::string_view text) {
    std::string plain(text.starts_with('+') ? text.substr(1) : text);
    if (std::count(plain.begin(), plain.end(), ',') == 1 && plain.find('.') == std::string::npos)
        std::replace(plain.begin(), plain.end(), ',', '.');
    return parse_number(plain);
}

std::string limit_text(const Limit& limit, double number, const std::string& unit) {
    const bool is_low = number < limit.low;
    const double end = is_low ? limit.low : limit.high;
    return fmt::format("{} {}{} is possible here; it was taken instead of {}",
                       is_low ? "at least" : "at most", format_number(end),
                       unit.empty() ? "" : " " + unit, format_number(number));
}
}  // namespace

TypedNumber read_typed_number(std::string_view text, const NumberFacts& facts) {
    text = trim(text);
    if (!facts.unit.empty() && text.ends_with(facts.unit))
        text = trim(text.substr(0, text.size() - facts.unit.size()));
    if (text.empty())
        return {};
    const auto time = facts.is_decay ? parse_decay(text) : std::nullopt;
    const auto number = time ? time : number_in(text);
    if (!number)
        return {{},
                fmt::format("'{}' is no number{}; the old value stays", text,
                            facts.is_decay ? " and no time as in 120 ms or 10% 0.4 s" : "")};
    if (!time && text.find(',') != std::string_view::npos && is_ambiguous(text))
        return {{},
                fmt::format("'{}' may mean {} or {}; write it with a point or without the comma",
                            text, format_number(*number), format_number(*number * 1000.0))};
    double value = *number;
    std::string complaint;
    if (facts.is_whole && value != std::round(value)) {
        value = std::round(value);
        complaint = fmt::format("only whole numbers are possible here; {} was taken instead of {}",
                                format_number(value), format_number(*number));
    }
    if (facts.limit && (value < facts.limit->low || value > facts.limit->high)) {
        complaint = limit_text(*facts.limit, value, facts.unit);
        value = std::clamp(value, facts.limit->low, facts.limit->high);
    }
    return {value, complaint};
}
