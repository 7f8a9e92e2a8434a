#include "model/look/decay.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

bool can_be_decay(const Parameter& parameter) {
    return parameter.control == Control::slider && parameter.type == NumberType{} &&
           parameter.range.low >= 0.0 && parameter.range.high <= 1.0;
}

bool is_decay(const Parameter& parameter) {
    return can_be_decay(parameter) &&
           (parameter.unit == "per 1/60 s" || parameter.scale == Scale::half_life);
}

double seconds_to(double share, double factor) {
    if (factor <= 0.0)
        return 0.0;
    if (factor >= 1.0)
        return std::numeric_limits<double>::infinity();
    return std::log(share) / (60.0 * std::log(factor));
}

double factor_leaving(double share, double seconds) {
    return std::pow(share, 1.0 / (60.0 * seconds));
}

namespace {
std::optional<double> number_before(std::string_view& text, std::string_view unit) {
    if (!text.ends_with(unit))
        return std::nullopt;
    std::string number(trim(text.substr(0, text.size() - unit.size())));
    if (number.find('.') == std::string::npos)
        std::replace(number.begin(), number.end(), ',', '.');
    return parse_number(number);
}

std::optional<double> seconds_in(std::string_view text) {
    if (const auto milliseconds = number_before(text, "ms"))
        return *milliseconds * 0.001;
    return number_before(text, "s");
}
}  // namespace

std::optional<double> parse_decay(std::string_view text) {
    text = trim(text);
    double share = 0.5;
    if (const auto end = text.find('%'); end != std::string_view::npos) {
        std::string_view percent = text.substr(0, end + 1);
        const auto left = number_before(percent, "%");
        if (!left || !(*left > 0.0) || !(*left < 100.0))
            return std::nullopt;
        share = *left / 100.0;
        text = trim(text.substr(end + 1));
    }
    const auto seconds = seconds_in(text);
    if (!seconds || !(*seconds > 0.0))
        return std::nullopt;
    return factor_leaving(share, *seconds);
}

std::string duration_text(double seconds) {
    if (!std::isfinite(seconds))
        return "forever";
    const bool is_short = seconds < 0.9995;
    const double number = is_short ? seconds * 1000.0 : seconds;
    const int decimals = number < 9.995 ? 2 : number < 99.95 ? 1 : 0;
    std::string text = fmt::format("{:.{}f}", number, decimals);
    if (text.find('.') != std::string::npos)
        text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.')
        text.pop_back();
    return text + (is_short ? " ms" : " s");
}
