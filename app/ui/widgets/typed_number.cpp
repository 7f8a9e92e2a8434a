#include "ui/widgets/typed_number.h"

#include "base/text.h"
#include "model/look/decay.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>

namespace {
// "1,000" and "12,345": a thousands separator or a decimal comma.
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
    const std::string end = format_number(number < limit.low ? limit.low : limit.high);
    const std::string typed = format_number(number);
    return unit.empty() ? fmt::format("Limited to {} (you typed {})", end, typed)
                        : fmt::format("Limited to {} {} (you typed {})", end, unit, typed);
}
}  // namespace

TypedNumber read_typed_number(std::string_view text, const NumberInfo& info) {
    text = trim(text);
    if (!info.unit.empty() && text.ends_with(info.unit))
        text = trim(text.substr(0, text.size() - info.unit.size()));
    if (text.empty())
        return {};
    const auto time = info.is_decay ? parse_decay(text) : std::nullopt;
    const auto number = time ? time : number_in(text);
    if (!number)
        return {{},
                info.is_decay
                    ? fmt::format("\"{}\" is neither a number nor a time such as 120 ms or 10% "
                                  "0.4 s. Value unchanged.",
                                  text)
                    : fmt::format("\"{}\" isn't a number. Value unchanged.", text)};
    if (!time && text.find(',') != std::string_view::npos && is_ambiguous(text))
        return {{},
                fmt::format("\"{}\" is ambiguous: type {} or {}", text, format_number(*number),
                            format_number(*number * 1000.0))};
    double value = *number;
    std::string complaint;
    if (info.is_whole && value != std::round(value)) {
        value = std::round(value);
        complaint =
            fmt::format("Rounded to {}, because only whole numbers are allowed (you typed {})",
                        format_number(value), format_number(*number));
    }
    if (info.limit && (value < info.limit->low || value > info.limit->high)) {
        complaint = limit_text(*info.limit, value, info.unit);
        value = std::clamp(value, info.limit->low, info.limit->high);
    }
    return {value, complaint};
}

Typing& typing() {
    return *static_cast<Typing*>(ImGui::GetIO().UserData);
}
