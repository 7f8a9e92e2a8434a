#include "glsl/annotations/guess.h"

#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace {
using Words = std::vector<std::string>;

// Both "beam_color" and "beamColor" give beam and color.
Words words_of(const std::string& name) {
    Words words{""};
    for (const char c : name) {
        const bool is_capital = c >= 'A' && c <= 'Z';
        if ((c == '_' || is_capital) && !words.back().empty())
            words.emplace_back();
        if (c != '_')
            words.back() += to_lower(std::string_view(&c, 1));
    }
    return words;
}

bool has_any(const Words& words, std::initializer_list<const char*> wanted) {
    return std::ranges::any_of(words, [&](const std::string& word) {
        return std::ranges::find(wanted, word) != wanted.end();
    });
}

bool is_color(const Words& words) {
    return has_any(words, {"color", "colour", "tint"});
}

bool is_point(const Words& words) {
    return has_any(words, {"point", "position", "center", "centre", "origin"});
}

bool is_angle(const Words& words) {
    return has_any(words, {"angle", "rotation"});
}

// Quantities with positive and negative values.
bool is_signed(const Words& words) {
    return has_any(words, {"offset", "shift", "direction", "bias", "tilt", "pan"});
}

// Quantities without a natural maximum of 1.
bool is_amount(const Words& words) {
    return has_any(words, {"gain", "exposure", "gamma", "contrast", "brightness", "intensity",
                           "speed", "rate", "scale", "zoom", "size", "radius", "width", "height",
                           "sigma", "period", "frequency", "sharpness"});
}

bool is_count(const Words& words) {
    return has_any(words,
                   {"count", "taps", "samples", "steps", "iterations", "octaves", "divisions"});
}

double largest(const Value& value) {
    double size = 0.0;
    for (const double number : value.numbers)
        size = std::max(size, std::abs(number));
    return size;
}

bool has_negative(const Value& value) {
    return std::ranges::any_of(value.numbers, [](double number) { return number < 0.0; });
}

double four_times(double size, Scalar scalar) {
    const double maximum = scalar == Scalar::floating  ? std::numeric_limits<float>::max()
                           : scalar == Scalar::integer ? 2147483647.0
                                                       : 4294967295.0;
    return std::min(4.0 * size, maximum);
}

Range whole_range(const Words& words, Scalar scalar, const Value& initial) {
    const double size = four_times(largest(initial), scalar);
    const double high = std::max(size, 10.0);
    if (has_negative(initial) || (scalar == Scalar::integer && is_signed(words)))
        return {-high, high, 1.0};
    return {is_count(words) && largest(initial) >= 1.0 ? 1.0 : 0.0, high, 1.0};
}

Range symmetric(double size) {
    const double end = size > 1.0 ? four_times(size, Scalar::floating) : 1.0;
    return {-end, end, 0.0};
}

Range float_range(const Words& words, const NumberType& type, const Value& initial) {
    const double size = largest(initial);
    if (type.columns > 1 || has_negative(initial) || (is_signed(words) && size <= 1.0))
        return symmetric(size);
    if (size > 1.0 || (size > 0.0 && is_amount(words)))
        return {0.0, four_times(size, Scalar::floating), 0.0};
    return {0.0, 1.0, 0.0};
}

void guess_angle(Parameter& parameter) {
    constexpr double turn = 2.0 * std::numbers::pi;
    const double size = largest(parameter.initial);
    if (size <= turn) {
        parameter.control = Control::angle;
        const double end = size <= turn / 2.0 ? turn / 2.0 : turn;
        parameter.range = {-end, end, 0.0};
    } else if (size <= 360.0) {  // probably degrees
        const double end = size <= 180.0 ? 180.0 : 360.0;
        parameter.range = {-end, end, 0.0};
    }
}

Range guessed_range(const Words& words, const NumberType& type, const Value& initial) {
    if (type.scalar == Scalar::boolean)
        return {0.0, 1.0, 1.0};
    if (type.scalar != Scalar::floating)
        return whole_range(words, type.scalar, initial);
    return float_range(words, type, initial);
}
}  // namespace

Parameter guessed_parameter(const std::string& name, const NumberType& type, const Value& initial) {
    const Words words = words_of(name);
    Parameter parameter;
    parameter.name = name;
    parameter.label = label_from_name(name);
    parameter.type = type;
    parameter.initial = initial;
    parameter.range = guessed_range(words, type, initial);
    const bool is_float_vector = type.scalar == Scalar::floating && type.columns == 1;
    if (is_float_vector && type.rows >= 3 && is_color(words)) {
        parameter.control = Control::color;
        parameter.range = {0.0, std::max(1.0, largest(initial)), 0.0};
    } else if (is_float_vector && type.rows == 2 && is_point(words)) {
        parameter.control = Control::point;
    } else if (is_float_vector && type.rows == 1 && is_angle(words)) {
        guess_angle(parameter);
    }
    return parameter;
}
