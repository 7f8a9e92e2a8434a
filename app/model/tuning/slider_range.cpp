#include "model/tuning/slider_range.h"

#include <algorithm>
#include <cmath>

double ratio_in(const Range& range, Scale scale, double value) {
    const double span = range.high - range.low;
    if (!(span > 0.0))
        return 0.0;
    const double inside = std::clamp(value, range.low, range.high);
    if (scale == Scale::linear)
        return (inside - range.low) / span;
    if (range.low > 0.0)
        return std::log(inside / range.low) / std::log(range.high / range.low);
    return std::cbrt((inside - range.low) / span);
}

double value_at(const Range& range, Scale scale, double ratio) {
    const double t = std::clamp(ratio, 0.0, 1.0);
    const double span = range.high - range.low;
    if (scale == Scale::linear)
        return range.low + t * span;
    if (range.low > 0.0)
        return range.low * std::pow(range.high / range.low, t);
    return range.low + span * t * t * t;
}

double readable(const Range& range, Scale scale, double value, double coarseness) {
    const double size = scale == Scale::logarithmic ? std::abs(value) : range.high - range.low;
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
