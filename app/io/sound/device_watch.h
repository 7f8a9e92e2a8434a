#pragma once

#include <atomic>
#include <chrono>

/// Detects a sound device that has stopped working. An unplugged device stops requesting buffers.
/// After a sound server dies, its stream requests them as fast as the processor can. The device's
/// thread calls served(), another thread is_lost().
class DeviceWatch {
public:
    using Clock = std::chrono::steady_clock;

    /// Call it before the device's thread starts.
    void start(Clock::time_point now) { m_served = now; }
    /// `seconds` of sound were transferred to or from the device. False if it runs too fast, so the
    /// stream must end.
    bool served(double seconds, Clock::time_point now) noexcept;
    /// Whether nothing was requested for 1 s (4 s at first), or the device runs too fast. A sound
    /// server needs time to start; its idle monitor delivers nothing for 2 s.
    bool is_lost(Clock::time_point now) const;

private:
    std::atomic<Clock::time_point> m_served = Clock::time_point{};
    std::atomic<bool> m_has_begun = false;
    std::atomic<bool> m_has_run_away = false;
    double m_ahead = 0.0;  // s, of the device's thread: transferred beyond real time
};
