#pragma once

#include "io/sound/sound_player.h"

#include <atomic>
#include <chrono>

/// The time of the sound that is heard now. Devices request buffers in bursts. The clock runs
/// smoothly through them and adjusts to the device's speed over half a second. The device's thread
/// reports filled buffers and one other thread reads; neither waits.
class SoundClock {
public:
    using Time = std::chrono::steady_clock::time_point;

    void buffer_filled(const SoundPlayer::Mixed& buffer, Time now) noexcept;

    /// Holds the position of a seek until a buffer follows it.
    void seek_started(std::uint64_t jump, double seconds);
    /// Seconds of the sound; never decreases except by a jump. `latency_seconds` is the time
    /// between filling a buffer and hearing it.
    double heard_seconds(Time now, double latency_seconds);

private:
    struct Snapshot {
        SoundPlayer::Mixed buffer;
        Time time;
    };
    Snapshot latest() const;
    void follow(double target, double speed, double passed);

    std::atomic<std::uint64_t> m_version = 0;  // odd while a snapshot is written
    std::atomic<double> m_begin_seconds = 0.0;
    std::atomic<double> m_seconds_per_second = 0.0;
    std::atomic<std::uint64_t> m_jump = 0;
    std::atomic<Time> m_time = Time{};

    std::uint64_t m_jump_asked = 0;
    double m_heard = 0.0;
    Time m_asked = {};  // time of the last call; zero after a jump
};
