#include "signals/scope/sweeps.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr double rounding = 1e-3;  // samples; rounding error of instants far from time 0
}  // namespace

std::int64_t Sweep::sample_after(double instant) {
    return static_cast<std::int64_t>(std::floor(instant + rounding));
}

std::int64_t Sweep::end() const {
    return std::min(sample_after(start + length), cut);
}

std::optional<Sweep> PeriodicSweeps::latest(std::int64_t sample) const {
    const double before = static_cast<double>(sample + 1) - rounding - m_start;
    if (before <= 0.0)
        return std::nullopt;
    const double number = m_period > 0.0 ? std::ceil(before / m_period) - 1.0 : 0.0;
    return Sweep{.start = m_start + number * m_period, .length = m_length};
}
