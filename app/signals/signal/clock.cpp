#include "signals/signal/clock.h"

#include <algorithm>
#include <cmath>
#include <limits>

TimeSpan frame_span(std::int64_t frame, double fps) {
    return {static_cast<double>(frame - 1) / fps, static_cast<double>(frame) / fps};
}

namespace {
// Number of instants at or before `seconds`. An end such as n / 60 times a rate can be a few
// rounding units below the exact whole number.
std::int64_t count_until(double seconds, double rate) {
    constexpr double min_slack = 1e-6;
    constexpr double roundings = 8.0 * std::numeric_limits<double>::epsilon();
    constexpr double maximum = 9e15;  // doubles above 2^53 skip whole numbers
    const double exact = seconds * rate;
    if (!(exact > 0.0))
        return 0;
    const double bounded = std::min(exact, maximum);
    return static_cast<std::int64_t>(bounded + std::max(min_slack, bounded * roundings));
}
}  // namespace

SampleRange samples_in(const TimeSpan& span, double rate) {
    const std::int64_t first = count_until(span.start, rate);
    return {first, std::max(first, count_until(span.end, rate))};
}
