#pragma once

#include "io/sound_player.h"

#include <atomic>
#include <chrono>

/// Tells the time of the sound that is heard now, between a device's buffers too. The device's
/// thread says when it has a buffer filled, one other thread asks; neither waits.
class SoundClock {
public:
    using Time = std::chrono::steady_clock::time_point;

    /// `buffer_seconds` is how long a buffer sounds.
    explicit SoundClock(double buffer_seconds) : m_buffer_seconds(buffer_seconds) {}

    void buffer_filled(const SoundPlayer::Mixed& buffer, Time now) noexcept;

    /// The position that a seek asked for holds until a buffer follows it.
    void jumped(std::uint64_t jump, double seconds);
    /// Seconds of the sound; never runs back but by a jump. `latency_seconds` passes between
    /// filling a buffer and hearing it.
    double heard_seconds(Time now, double latency_seconds);
    /// For how long no buffer was asked for.
    double seconds_since_buffer(Time now) const;

private:
    struct Snapshot {
        SoundPlayer::Mixed buffer;
        Time time;
    };
    Snapshot latest() const;

    double m_buffer_seconds;
    std::atomic<std::uint64_t> m_version = 0;  // odd while a snapshot is being written
    std::atomic<double> m_begin_seconds = 0.0;
    std::atomic<double> m_seconds_per_second = 0.0;
    std::atomic<std::uint64_t> m_jump = 0;
    std::atomic<Time> m_time = Time{};

    std::uint64_t m_jump_asked = 0;
    double m_heard = 0.0;
};
