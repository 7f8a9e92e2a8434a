#include "model/picture/plot_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

double rounded_up(double number) {
    constexpr std::array steps{1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0};
    if (!(number > 0.0) || !std::isfinite(number))
        return 0.0;
    const double power = std::pow(10.0, std::floor(std::log10(number)));
    constexpr double slack = 1.0 - 1e-6;  // for rounding errors
    for (const double step : steps)
        if (number * slack <= step * power)
            return step * power;
    return 10.0 * power;
}

std::vector<double> axis_ticks(const PlotRange& range, int maximum) {
    const double width = range.high - range.low;
    if (!(width > 0.0))
        return {range.low};
    const double finest = width / maximum;
    const double power = std::pow(10.0, std::floor(std::log10(finest)));
    std::vector<double> numbers;
    for (const double step : {1.0, 2.0, 5.0, 10.0, 20.0}) {
        const double apart = step * power;
        constexpr double slack = 1e-6;
        const double first = std::ceil(range.low / apart - slack);
        const double last = std::floor(range.high / apart + slack);
        if (last - first + 1.0 > maximum)
            continue;
        for (double i = first; i <= last; i += 1.0)
            numbers.push_back(i * apart + 0.0);  // avoids -0
        break;
    }
    return numbers;
}

void SteadyRange::cover(double minimum, double greatest, double seconds) {
    constexpr double hold_seconds = 2.0;
    const double high = rounded_up(greatest);
    PlotRange needed{-rounded_up(-minimum), high};
    if (needed.low == 0.0 && needed.high == 0.0)
        needed.high = 1.0;
    const bool is_larger = needed.low < m_range.low || needed.high > m_range.high;
    if (needed == m_range || m_is_new || is_larger)
        m_needed = seconds;
    if (m_is_new || seconds > m_needed + hold_seconds) {
        m_range = needed;
        m_needed = seconds;
    } else if (is_larger) {
        m_range = {std::min(needed.low, m_range.low), std::max(needed.high, m_range.high)};
    }
    m_is_new = false;
}
