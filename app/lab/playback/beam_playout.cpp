#include "lab/playback/beam_playout.h"

#include <algorithm>

void BeamPlayout::set_signal(std::unique_ptr<Signal> signal, bool is_known_ahead) {
    m_signal = std::move(signal);
    m_is_known_ahead = is_known_ahead;
    m_is_running = false;
}

void BeamPlayout::rest() {
    m_output->queue().start_anew();
    m_is_running = false;
}

void BeamPlayout::follow(double time, double speed) {
    constexpr double max_waiting = 0.4;  // s
    BeamQueue& queue = m_output->queue();
    const double rate = queue.rate();
    const double end = time + lead() * speed;
    const double waiting = static_cast<double>(queue.waiting()) / rate;
    if (!m_is_running || waiting == 0.0 || waiting > max_waiting ||
        end - m_played > max_waiting * speed) {
        rest();
        m_played = std::max(end - cushion() * speed, 0.0);
        m_sampler.start_at(m_played);
        m_is_running = true;
    }
    if (!m_signal || end <= m_played)
        return;
    const TimeSpan span{m_played, end};
    m_beam.clear();
    m_signal->trace(span, m_beam);
    // The clocks of device and picture drift, so the sampling rate is adjusted by up to 1 %.
    const double surplus =
        static_cast<double>(queue.waiting()) / rate + span.seconds() / speed - cushion();
    const double pace = 1.0 + std::clamp(0.2 * surplus, -0.01, 0.01);
    m_samples.clear();
    m_sampler.take(span, m_beam, {.step = pace * speed / rate}, m_samples);
    queue.write(m_samples);
    m_played = end;
}
