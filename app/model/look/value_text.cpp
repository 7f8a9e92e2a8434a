#include "model/look/value_text.h"

#include "base/text.h"
#include "model/look/color.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace {
std::string number_text(double number, int digits) {
    const auto rounded = parse_number(fmt::format("{:.{}g}", number, digits));
    return rounded ? format_number(*rounded) : fmt::format("{}", number);
}

bool has_hex(const Parameter& parameter, const Value& value) {
    return parameter.control == Control::color && value.numbers.size() >= 3 &&
           std::all_of(value.numbers.begin(), value.numbers.end(),
                       [](double part) { return part >= 0.0 && part <= 1.0; });
}

std::string hex_text(const Value& value) {
    std::string text = "#";
    for (std::size_t i = 0; i < value.numbers.size(); ++i) {
        const double part = i < 3 ? srgb_encode(value.numbers[i]) : value.numbers[i];
        text += fmt::format("{:02x}", std::lround(part * 255.0));
    }
    return text;
}
}  // namespace

std::string value_text(const Parameter& parameter, const Value& value, int digits) {
    if (!value.path.empty())
        return std::filesystem::path(value.path).filename().string();
    if (value.numbers.empty())
        return "none";
    for (const Item& item : parameter.items)
        if (item.value == value.number())
            return item.label;
    if (has_hex(parameter, value))
        return hex_text(value);
    const double factor = parameter.control == Control::angle ? 180.0 / std::numbers::pi : 1.0;
    std::string text;
    for (const double number : value.numbers) {
        text += text.empty() ? "" : ", ";
        if (parameter.type.scalar == Scalar::boolean)
            text += number != 0.0 ? "on" : "off";
        else
            text += number_text(number * factor, digits);
    }
    return text;
}

bool is_period(const Parameter& parameter) {
    return parameter.control == Control::slider && parameter.type == NumberType{} &&
           (parameter.unit == "px per period" || parameter.unit == "px a period");  // earlier looks
}

std::string_view shown_unit(const Parameter& parameter) {
    return is_period(parameter) ? std::string_view("px") : std::string_view(parameter.unit);
}

std::string unit_text(const Parameter& parameter) {
    return parameter.control == Control::angle ? "°" : std::string(shown_unit(parameter));
}
