#pragma once

#include "signals/signal/points.h"
#include "signals/signal/settings.h"

#include <memory>
#include <vector>

/// A signal of one wave, drawn over time (yt) or against itself a quarter period earlier (xy).
/// `Wave` is called with a time in sweeps of 1/60 s. Its quarter_period has the same unit, and
/// frequencies() are in periods per sweep.
template <class Wave>
class OneChannel : public Signal {
public:
    explicit OneChannel(const Settings& settings)
        : m_wave(settings),
          m_amplitude(settings.number("amplitude")),
          m_scroll(settings.number("speed") / 60.0),
          m_points(settings.whole("points")),
          m_charge(charge_of_point(static_cast<double>(m_points) * 60.0)),
          m_is_xy(settings.is("mode", "xy")) {}

    void trace(const TimeSpan& span, Beam& beam) const override {
        trace_points(span, {.rate = static_cast<double>(m_points) * 60.0}, beam,
                     [this](std::int64_t k) { return m_is_xy ? against_itself(k) : swept(k); });
    }

    Repetition repetition() const override {
        Repetition repetition;
        if (!m_is_xy)
            repetition.add(60.0);
        for (const double frequency : m_wave.frequencies())
            repetition.add(60.0 * frequency * (m_is_xy ? 1.0 : m_scroll));
        return repetition;
    }

private:
    BeamPoint against_itself(std::int64_t k) const {
        const double u = static_cast<double>(k + 1) / static_cast<double>(m_points);
        return {static_cast<float>(m_amplitude * m_wave(u)),
                static_cast<float>(m_amplitude * m_wave(u - m_wave.quarter_period)),
                static_cast<float>(m_charge)};
    }

    BeamPoint swept(std::int64_t k) const {
        const std::int64_t sweep = k / m_points;
        const SweepPoint point = sweep_point(k % m_points, m_points, m_charge);
        const double u = point.across + m_scroll * static_cast<double>(sweep);
        return {point.x, static_cast<float>(m_amplitude * m_wave(u)), point.intensity};
    }

    Wave m_wave;
    double m_amplitude;
    double m_scroll;  // sweeps per sweep
    std::int64_t m_points;
    double m_charge;
    bool m_is_xy;
};

template <class Wave>
Result<std::unique_ptr<Signal>> make_one_channel(const Settings& settings, const SignalMedia&) {
    return std::make_unique<OneChannel<Wave>>(settings);
}

/// A frequency in periods across the screen.
SettingInfo periods_setting(std::string key, std::string label, std::string help, double initial);

/// The kind's own settings, then the settings that OneChannel reads.
std::vector<SettingInfo> one_channel_settings(std::vector<SettingInfo> own);
