#include "io/sound/sound_clock.h"

#include <algorithm>

void SoundClock::buffer_filled(const SoundPlayer::Mixed& buffer, Time now) noexcept {
    ++m_version;
    m_begin_seconds = buffer.begin_seconds;
    m_seconds_per_second = buffer.seconds_per_second;
    m_jump = buffer.jump;
    m_time = now;
    ++m_version;
}

// Retries if a buffer was filled in between, which happens at most once in some milliseconds.
SoundClock::Snapshot SoundClock::latest() const {
    for (;;) {
        const std::uint64_t before = m_version;
        const Snapshot snapshot{{m_begin_seconds, m_seconds_per_second, m_jump}, m_time};
        if (before % 2 == 0 && before == m_version)
            return snapshot;
    }
}

void SoundClock::seek_started(std::uint64_t jump, double seconds) {
    m_jump_asked = jump;
    m_heard = seconds;
    m_asked = {};
}

double SoundClock::heard_seconds(Time now, double latency_seconds) {
    constexpr double longest_gap =
        0.1;  // s; after a longer gap the device has nothing more to play
    const Snapshot snapshot = latest();
    if (snapshot.buffer.jump < m_jump_asked || snapshot.time == Time{})
        return m_heard;
    const double since = std::chrono::duration<double>(now - snapshot.time).count();
    const double speed = snapshot.buffer.seconds_per_second;
    const double played = std::clamp(since, 0.0, longest_gap) - latency_seconds;
    const double target = snapshot.buffer.begin_seconds + played * speed;
    if (m_asked == Time{})
        m_heard = std::max(m_heard, target);
    else
        follow(target, since < longest_gap ? speed : 0.0,
               std::chrono::duration<double>(now - m_asked).count());
    m_asked = now;
    return m_heard;
}

void SoundClock::follow(double target, double speed, double passed) {
    constexpr double settle_seconds = 0.5;
    double next = 0.0;
    if (speed > 0.0) {
        const double expected = m_heard + passed * speed;
        next = expected + (target - expected) * std::min(passed / settle_seconds, 1.0);
    } else {
        next = std::min(target, m_heard + passed);  // queued sound is heard to its end
    }
    m_heard = std::max(m_heard, next);
}
