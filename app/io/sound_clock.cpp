#include "io/sound_clock.h"

#include <algorithm>

void SoundClock::buffer_filled(const SoundPlayer::Mixed& buffer, Time now) noexcept {
    ++m_version;
    m_begin_seconds = buffer.begin_seconds;
    m_seconds_per_second = buffer.seconds_per_second;
    m_jump = buffer.jump;
    m_time = now;
    ++m_version;
}

// Reads again when a buffer came in between, which is at most once in some milliseconds.
SoundClock::Snapshot SoundClock::latest() const {
    for (;;) {
        const std::uint64_t before = m_version;
        const Snapshot snapshot{{m_begin_seconds, m_seconds_per_second, m_jump}, m_time};
        if (before % 2 == 0 && before == m_version)
            return snapshot;
    }
}

void SoundClock::jumped(std::uint64_t jump, double seconds) {
    m_jump_asked = jump;
    m_heard = seconds;
}

double SoundClock::heard_seconds(Time now, double latency_seconds) {
    const Snapshot snapshot = latest();
    if (snapshot.buffer.jump < m_jump_asked || snapshot.time == Time{})
        return m_heard;
    const double since = std::chrono::duration<double>(now - snapshot.time).count();
    // A device that comes late has nothing more to let us hear.
    const double passed = std::clamp(since, 0.0, 2.0 * m_buffer_seconds) - latency_seconds;
    const double position =
        snapshot.buffer.begin_seconds + passed * snapshot.buffer.seconds_per_second;
    m_heard = std::max(m_heard, position);
    return m_heard;
}

double SoundClock::seconds_since_buffer(Time now) const {
    return std::chrono::duration<double>(now - latest().time).count();
}
