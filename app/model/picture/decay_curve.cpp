#include "model/picture/decay_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace {
using Samples = std::span<const double>;

std::optional<double> time_to(double share, Samples seconds, Samples light, std::size_t peak) {
    const double level = share * light[peak];
    std::size_t last = light.size() - 1;  // the last sample above the level
    while (last > peak && light[last] <= level)
        --last;
    if (last + 1 == light.size())
        return std::nullopt;
    const double high = light[last];
    const double low = light[last + 1];
    const double way =
        low > 0.0 ? std::log(high / level) / std::log(high / low) : (high - level) / (high - low);
    return seconds[last] + way * (seconds[last + 1] - seconds[last]) - seconds[peak];
}

std::optional<double> fitted_half_life(Samples seconds, Samples light, std::size_t peak) {
    constexpr double minimum = 0.01;
    double count = 0.0;
    double sum_x = 0.0;
    double sum_y = 0.0;
    double sum_xx = 0.0;
    double sum_xy = 0.0;
    for (std::size_t i = peak; i < light.size() && light[i] >= minimum * light[peak]; ++i) {
        const double x = seconds[i] - seconds[peak];
        const double y = std::log(light[i]);
        count += 1.0;
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    const double spread = count * sum_xx - sum_x * sum_x;
    if (spread <= 0.0)
        return std::nullopt;
    const double slope = (count * sum_xy - sum_x * sum_y) / spread;
    constexpr double still = 1e-9;  // per second
    return slope < -still ? std::optional(-std::numbers::ln2 / slope) : std::nullopt;
}
}  // namespace

DecayCurve decay_curve(Samples seconds, Samples light) {
    assert(seconds.size() == light.size());
    DecayCurve decay;
    const auto greatest = std::ranges::max_element(light);
    if (greatest == light.end() || !(*greatest > 0.0))
        return decay;
    const auto peak = static_cast<std::size_t>(greatest - light.begin());
    decay.peak = light[peak];
    decay.peak_seconds = seconds[peak];
    decay.to_tenth = time_to(0.1, seconds, light, peak);
    decay.to_hundredth = time_to(0.01, seconds, light, peak);
    decay.to_thousandth = time_to(0.001, seconds, light, peak);
    decay.half_life = fitted_half_life(seconds, light, peak);
    return decay;
}
