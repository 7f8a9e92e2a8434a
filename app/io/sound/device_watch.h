#pragma once

#include <atomic>
#include <chrono>

/// Tells whether a sound device still does its work. One that was pulled out asks for nothing more;
/// a sound server that died leaves a stream that asks as fast as the processor can. The device's
/// thread says when it was served, another one asks.
class DeviceWatch {
public:
    using Clock = std::chrono::steady_clock;

    /// Before the device's thread begins.
    void start(Clock::time_point now) { m_served = now; }
    /// `seconds` of sound went to or came from the device. False: it ran away, so the stream is to
    /// end.
    bool served(double seconds, Clock::time_point now) noexcept;
    /// Whether nothing was asked for a second, at first for four, or it ran away. A sound server
    /// takes its time to start; an idle monitor of one gives nothing for two.
    bool is_lost(Clock::time_point now) const;

private:
    std::atomic<Clock::time_point> m_served = Clock::time_point{};
    std::atomic<bool> m_has_begun = false;
    std::atomic<bool> m_has_run_away = false;
    double m_ahead = 0.0;  // s, of the device's thread: served beyond what time allows
};
