#include "model/tuning/slider_range.h"

#include "model/look/decay.h"

#include <algorithm>
#include <cmath>

namespace {
// Half-lives at the ends of a slider. Factors of 0 and 1 have none, so their ends are limited.
struct HalfLives {
    double low;
    double high;

    explicit HalfLives(const Range& range)
        : low(limited(half_life(range.low))), high(limited(half_life(range.high))) {}

    static double limited(double seconds) { return std::clamp(seconds, 0.001, 100.0); }

    double ratio(double factor) const {
        return std::log(limited(half_life(factor)) / low) / std::log(high / low);
    }
    double factor(double ratio) const {
        return factor_leaving(0.5, low * std::pow(high / low, ratio));
    }
};
}  // namespace

double ratio_in(const Range& range, Scale scale, double value) {
    const double span = range.high - range.low;
    if (!(span > 0.0))
        return 0.0;
    const double inside = std::clamp(value, range.low, range.high);
    if (scale == Scale::linear)
        return (inside - range.low) / span;
    if (scale == Scale::half_life && inside > range.low && inside < range.high)
        return std::clamp(HalfLives(range).ratio(inside), 0.0, 1.0);
    if (scale == Scale::half_life)
        return inside > range.low ? 1.0 : 0.0;
    if (range.low > 0.0)
        return std::log(inside / range.low) / std::log(range.high / range.low);
    return std::cbrt((inside - range.low) / span);
}

double value_at(const Range& range, Scale scale, double ratio) {
    const double t = std::clamp(ratio, 0.0, 1.0);
    const double span = range.high - range.low;
    if (scale == Scale::linear)
        return range.low + t * span;
    if (scale == Scale::half_life && t > 0.0 && t < 1.0)
        return std::clamp(HalfLives(range).factor(t), range.low, range.high);
    if (scale == Scale::half_life)
        return t > 0.0 ? range.high : range.low;
    if (range.low > 0.0)
        return range.low * std::pow(range.high / range.low, t);
    return range.low + span * t * t * t;
}

double readable(const Range& range, Scale scale, double value, double coarseness) {
    const double size = scale == Scale::logarithmic ? std::abs(value)
                        : scale == Scale::half_life ? 1.0 - value
                                                    : range.high - range.low;
    if (!(size > 0.0))
        return value;
    const double step = std::pow(10.0, std::floor(std::log10(size / 500.0))) * coarseness;
    return std::clamp(std::round(value / step) * step, range.low, range.high);
}

double Steps::nearest(double wanted) const {
    return value(std::clamp(std::round((wanted - first) / step), 0.0, count - 1.0));
}

std::optional<Steps> steps_in(const Range& range, double origin) {
    if (!(range.step > 0.0))
        return std::nullopt;
    constexpr double slack = 1e-6;  // ends are decimals, which doubles only approximate
    const double low = std::ceil((range.low - origin) / range.step - slack);
    const double high = std::floor((range.high - origin) / range.step + slack);
    if (!(high >= low))
        return std::nullopt;
    return Steps{origin + low * range.step, range.step, high - low + 1.0};
}

double step_of(const Parameter& parameter) {
    const bool is_whole = parameter.type.scalar != Scalar::floating;
    return is_whole ? std::max(1.0, std::round(parameter.range.step)) : parameter.range.step;
}

bool has_parts(const Parameter& parameter) {
    return parameter.control == Control::slider && parameter.type.scalar != Scalar::boolean &&
           parameter.type.rows > 1 && parameter.type.columns == 1;
}
