#include "base/fitted_number.h"

#include <fmt/format.h>

#include <cmath>

namespace {
// Removes zeros and "+" from the exponent: "1.5e-05" becomes "1.5e-5".
std::string without_padding(std::string text) {
    const std::size_t power = text.find('e');
    if (power == std::string::npos)
        return text;
    const std::size_t sign = power + 1;
    const std::size_t digits = text.find_first_not_of('0', sign + 1);
    text.erase(sign + 1, digits - sign - 1);
    if (text[sign] == '+')
        text.erase(sign, 1);
    return text;
}
}  // namespace

std::string fitted_number(double number, int maximum) {
    if (!std::isfinite(number))
        return std::isnan(number) ? "NaN" : number > 0.0 ? "Inf" : "-Inf";
    constexpr int max_digits = 7;
    std::string text;
    for (int digits = max_digits; digits > 0; --digits) {
        text = without_padding(fmt::format("{:.{}g}", number, digits));
        if (text.size() <= static_cast<std::size_t>(maximum))
            break;
    }
    return text == "-0" ? "0" : text;
}
