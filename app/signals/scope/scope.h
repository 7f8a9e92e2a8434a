#pragma once

#include "signals/scope/scope_controls.h"
#include "signals/scope/sweeps.h"
#include "signals/signal/points.h"
#include "signals/signal/stereo_sample.h"

/// The screen of a two-channel oscilloscope: converts two voltages to beam points. Traces over time
/// go from -1 to 1 across 10 divisions. Vertically, and on both axes in xy, a division is 0.25.
class Scope {
public:
    /// `is_shown`: channels with a trace. `rate`: of the input, in samples per second.
    Scope(const ScopeControls& controls, std::array<bool, 2> is_shown, double rate);

    /// Appends the points of the samples in `span`, up to sample `count`. `volts(k, start)` returns
    /// sample k after the coupling, in a sweep that started at `start` seconds.
    template <class Volts>
    void trace(const TimeSpan& span, std::int64_t count, const Sweeps& sweeps, Beam& beam,
               const Volts& volts) const;

    double rate() const { return m_rate; }
    double sweep_samples() const { return m_sweep_samples; }

private:
    /// A stretch of one trace that is drawn without a gap.
    struct Stretch {
        int channel = 0;
        std::int64_t sample = 0;
        bool is_first_point = false;
        std::int64_t points = 0;
    };
    Stretch stretch_of(const Sweep& sweep, std::int64_t point) const;

    std::int64_t traces() const { return m_second < 0 ? 1 : 2; }
    float deflection(int channel, float volts) const {
        const auto index = static_cast<std::size_t>(channel);
        return volts * m_scale[index] + m_offset[index];
    }
    BeamPoint on_sweep(const Sweep& sweep, const Stretch& stretch, StereoSample volts) const;

    double m_rate;
    double m_sweep_samples;
    bool m_is_xy;
    int m_first;   // visible channels, from 0; -1: none
    int m_second;  // -1 in xy
    std::array<float, 2> m_scale{};
    std::array<float, 2> m_offset{};
    double m_charge;
};

template <class Volts>
void Scope::trace(const TimeSpan& span, std::int64_t count, const Sweeps& sweeps, Beam& beam,
                  const Volts& volts) const {
    if (!m_is_xy && m_first < 0)
        return;
    PointStream stream{.rate = m_rate * static_cast<double>(traces())};
    if (count < stream.count / traces())
        stream.count = count * traces();
    std::optional<Sweep> sweep;
    std::int64_t sweep_end = 0;
    trace_points(span, stream, beam, [&](std::int64_t point) {
        const std::int64_t sample = point / traces();
        if (m_is_xy) {
            const StereoSample both = volts(sample, 0.0);
            return BeamPoint{deflection(0, both.left), deflection(1, both.right),
                             static_cast<float>(m_charge)};
        }
        if (sample >= sweep_end) {
            sweep = sweeps.latest(sample);
            sweep_end = sweep ? sweep->end() : 0;
        }
        if (sample >= sweep_end)
            return BeamPoint{-1.0f, 0.0f, 0.0f};  // blanked while waiting
        const Stretch stretch = stretch_of(*sweep, point);
        return on_sweep(*sweep, stretch, volts(stretch.sample, sweep->start / m_rate));
    });
}
