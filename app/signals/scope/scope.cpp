#include "signals/scope/scope.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr double half_height = ScopeControls::divisions_up / 2.0;
}  // namespace

Scope::Scope(const ScopeControls& controls, std::array<bool, 2> is_shown, double rate)
    : m_rate(rate),
      m_sweep_samples(controls.sweep_seconds() * rate),
      m_is_xy(controls.is_xy),
      m_first(is_shown[0]   ? 0
              : is_shown[1] ? 1
                            : -1),
      m_second(is_shown[0] && is_shown[1] && !controls.is_xy ? 1 : -1),
      m_charge(charge_of_point(rate * static_cast<double>(traces()))) {
    const bool is_split = controls.is_split && m_second >= 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const ScopeChannel& channel = controls.channels[i];
        double scale = 1.0 / (channel.volts_per_division * half_height);
        double offset = channel.offset / half_height;
        if (is_split) {
            scale *= 0.5;
            offset = 0.5 * offset + (i == 0 ? 0.5 : -0.5);
        }
        m_scale[i] = static_cast<float>(channel.is_inverted ? -scale : scale);
        m_offset[i] = static_cast<float>(offset);
    }
}

// A single trace is drawn in real time. Two traces alternate: each stretch of at most 1/60 s is
// drawn at double speed on one channel, then on the other. Both get the same light.
Scope::Stretch Scope::stretch_of(const Sweep& sweep, std::int64_t point) const {
    const std::int64_t first = sweep.first();
    const std::int64_t samples = sweep.end() - first;
    if (m_second < 0)
        return {m_first, point, point == first, samples};
    const double turns = std::max(std::ceil(m_sweep_samples * 60.0 / m_rate - 1e-6), 1.0);
    const auto whole = static_cast<std::int64_t>(std::ceil(static_cast<double>(samples) / turns));
    const std::int64_t index = point - 2 * first;
    const std::int64_t begin = index / (2 * whole) * whole;
    const std::int64_t length = std::min(whole, samples - begin);
    const std::int64_t within = index - 2 * begin;
    const std::int64_t along = within % length;
    return {within < length ? m_first : m_second, first + begin + along, along == 0, length};
}

// The move to the first point of a stretch is blanked. Its light is distributed over the other
// points.
BeamPoint Scope::on_sweep(const Sweep& sweep, const Stretch& stretch, StereoSample volts) const {
    const auto points = static_cast<double>(stretch.points);
    const double light = stretch.is_first_point ? 0.0 : m_charge * points / (points - 1.0);
    const double x = 2.0 * sweep.across(stretch.sample) - 1.0;
    const float y = deflection(stretch.channel, stretch.channel == 0 ? volts.left : volts.right);
    return {static_cast<float>(std::min(x, 1.0)), y, static_cast<float>(light)};
}
