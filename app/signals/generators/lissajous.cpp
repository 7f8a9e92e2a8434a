#include "signals/generators/lissajous.h"

#include "signals/signal/points.h"
#include "signals/signal/settings.h"
#include "signals/signal/sine.h"

#include <cmath>

namespace {
// Current 0.3 + 0.7 q, q = 0.05 / (s + 0.05): 1 for a stationary beam, 1/21 at full speed (s = 1).
double current_at(double speed) {
    constexpr double floor = 0.3;
    constexpr double softness = 0.05;
    return floor + (1.0 - floor) * softness / (speed + softness);
}

class Lissajous : public Signal {
public:
    explicit Lissajous(const Settings& settings)
        : m_x(settings.number("x")),
          m_y(settings.number("y")),
          m_phase(settings.number("phase")),
          m_amplitude(settings.number("amplitude")),
          m_drift(settings.number("speed") / 60.0),
          m_points(settings.number("points")),
          m_weighted(settings.is("weighting", "speed")),
          m_fastest(std::hypot(m_x + m_drift, m_y)) {}

    void trace(const TimeSpan& span, Beam& beam) const override {
        const double rate = m_points * 60.0;
        const double charge = charge_of_point(rate);
        trace_points(span, {.rate = rate}, beam, [&](std::int64_t k) {
            const double u = static_cast<double>(k + 1) / m_points;
            const double across = (m_x + m_drift) * u + m_phase;
            const double up = m_y * u;
            const double current = m_weighted ? current_at(relative_speed(across, up)) : 1.0;
            return BeamPoint{static_cast<float>(m_amplitude * sine(across)),
                             static_cast<float>(m_amplitude * sine(up)),
                             static_cast<float>(charge * current)};
        });
    }

    Repetition repetition() const override {
        Repetition repetition;
        repetition.add((m_x + m_drift) * 60.0);
        repetition.add(m_y * 60.0);
        return repetition;
    }

private:
    // Speed of the beam relative to both deflections at their maximum speed.
    double relative_speed(double across, double up) const {
        if (m_fastest == 0.0)
            return 0.0;
        const double vx = (m_x + m_drift) * cosine(across);
        const double vy = m_y * cosine(up);
        return std::sqrt(vx * vx + vy * vy) / m_fastest;
    }

    double m_x;
    double m_y;
    double m_phase;
    double m_amplitude;
    double m_drift;  // turns per 1/60 s
    double m_points;
    bool m_weighted;
    double m_fastest;
};

SettingInfo frequency_setting(std::string key, std::string label, double initial) {
    return {.key = std::move(key),
            .label = std::move(label),
            .unit = "per 1/60 s",
            .help = "Periods per 1/60 s. With whole numbers the figure closes in that time.",
            .low = 1,
            .high = 12,
            .initial = initial,
            .limit = {-1000, 1000}};
}
}  // namespace

SignalKind lissajous_kind() {
    return {
        .kind = "lissajous",
        .label = "Lissajous figure",
        .help = "Two sines, one horizontal and one vertical. A whole figure is drawn each 1/60 s.",
        .settings = {frequency_setting("x", "X frequency", 3),
                     frequency_setting("y", "Y frequency", 2),
                     {.key = "phase",
                      .label = "Phase",
                      .unit = "turns",
                      .help = "Phase of the horizontal sine relative to the vertical one.",
                      .initial = 0.25},
                     amplitude_setting(0.8),
                     {.key = "speed",
                      .label = "Drift",
                      .unit = "turns/s",
                      .help = "Speed of the phase. 0 stops it.",
                      .low = -1,
                      .high = 1,
                      .limit = {-1000, 1000}},
                     points_setting(),
                     {.key = "weighting",
                      .label = "Weighting",
                      .help = "constant: constant beam current. speed: the current falls with "
                              "the beam's speed, as 0.3 + 0.7 * 0.05 / (s + 0.05), where s is "
                              "the speed relative to the maximum.",
                      .type = SettingType::word,
                      .words = {"constant", "speed"},
                      .initial_word = "constant"}},
        .make = [](const Settings& settings, const SignalMedia&)
            -> Result<std::unique_ptr<Signal>> { return std::make_unique<Lissajous>(settings); }};
}
