#include "signals/beam/beam_sampler.h"

#include "signals/signal/points.h"

#include <cmath>

namespace {
constexpr double instant_slack = 1e-10;  // s: tolerance for instants computed in two ways

// Charge relative to full current over the same time.
double current_of(double charge, double seconds) {
    return seconds > 0.0 ? charge / (charge_of_point(1.0) * seconds) : 0.0;
}
}  // namespace

void BeamSampler::start_at(double seconds) {
    m_sampled = seconds;
    m_last.time = seconds;
    m_last.current = 0.0;
}

void BeamSampler::take(const TimeSpan& span, const Beam& beam, const Format& format,
                       std::vector<float>& samples) {
    for (const BeamPoint& point : beam) {
        const double time = span.end - static_cast<double>(point.age_seconds);
        const double current = current_of(static_cast<double>(point.intensity), time - m_last.time);
        go_to({time, static_cast<double>(point.x), static_cast<double>(point.y), current}, format,
              samples);
    }
    if (span.end - m_last.time > m_rest_seconds)
        go_to({span.end, m_last.x, m_last.y, 0.0}, format, samples);
}

void BeamSampler::go_to(const Instant& next, const Format& format, std::vector<float>& samples) {
    const double span = next.time - m_last.time;
    while (m_sampled + format.step <= next.time + instant_slack) {
        m_sampled += format.step;
        const double share = span > 0.0 ? (m_sampled - m_last.time) / span : 1.0;
        samples.push_back(static_cast<float>(std::lerp(m_last.x, next.x, share)));
        samples.push_back(static_cast<float>(std::lerp(m_last.y, next.y, share)));
        if (format.channels > 2)
            samples.push_back(static_cast<float>(next.current));
    }
    m_last = next;
}

void BeamSampler::rest(const Format& format, std::vector<float>& samples) {
    go_to({m_sampled + format.step, m_last.x, m_last.y, 0.0}, format, samples);
}
