#include "model/aliasing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

bool is_period(const Parameter& parameter) {
    return parameter.control == Control::slider && parameter.type == NumberType{} &&
           parameter.unit == "px a period";
}

std::string_view shown_unit(const Parameter& parameter) {
    return is_period(parameter) ? std::string_view("px") : std::string_view(parameter.unit);
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
    constexpr double seen = 0.05;
    if (!(period > 0.0) || unevenness_of(period) < seen)
        return std::nullopt;
    const double beat = beat_of(period);
    return beat <= length ? std::optional(beat) : std::nullopt;
}

std::vector<double> safe_periods(double low, double high) {
    constexpr double most = 1000.0;
    std::vector<double> periods;
    for (double p = std::max(2.0, std::ceil(low)); p <= std::min(high, most); p += 1.0)
        periods.push_back(p);
    return periods;
}
