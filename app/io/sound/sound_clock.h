#pragma once

#include "io/sound/sound_player.h"

#include <atomic>
#include <chrono>

/// Tells the time of the sound that is heard now. Devices ask for buffers in bursts; the clock runs
/// evenly through them and follows the device's own speed over half a second. The device's thread
/// says when it has filled a buffer, one other thread asks; neither waits.
class SoundClock {
public:
    using Time = std::chrono::steady_clock::time_point;

    void buffer_filled(const SoundPlayer::Mixed& buffer, Time now) noexcept;

    /// The position that a seek asked for holds until a buffer follows it.
    void jumped(std::uint64_t jump, double seconds);
    /// Seconds of the sound; never runs back but by a jump. `latency_seconds` passes between
    /// filling a buffer and hearing it.
    double heard_seconds(Time now, double latency_seconds);

private:
    struct Snapshot {
        SoundPlayer::Mixed buffer;
        Time time;
    };
    Snapshot latest() const;
    void follow(double target, double speed, double passed);

    std::atomic<std::uint64_t> m_version = 0;  // odd while a snapshot is being written
    std::atomic<double> m_begin_seconds = 0.0;
    std::atomic<double> m_seconds_per_second = 0.0;
    std::atomic<std::uint64_t> m_jump = 0;
    std::atomic<Time> m_time = Time{};

    std::uint64_t m_jump_asked = 0;
    double m_heard = 0.0;
    Time m_asked = {};  // when it was last told; none since a jump
};
