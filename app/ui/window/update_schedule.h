#pragma once

#include "ui/window/toolkit.h"

#include <chrono>

class Lab;

/// When the window updates and draws its panels. It rests while nothing changes, and leaves most of
/// the time to a slow look.
class UpdateSchedule {
public:
    UpdateSchedule(const Lab& lab, const gpu::WindowEvents& events, const Toolkit& toolkit);

    /// Waits until an update is due: at most `frame_seconds` after the last one. While idle, it
    /// waits for input or file changes, and returns false about once a second to update the
    /// session. `is_pending`: displayed results are still pending.
    bool wait(double frame_seconds, bool is_pending);
    /// Draws a few more updates, because widgets react a frame or two later.
    void stay_awake();

    /// Returns the wall time since the last update, in seconds.
    double begin_update();
    /// Whether the panels wait for the first picture. It is then displayed with them.
    bool is_before_panels();
    /// Whether the panels need a new frame in this update.
    bool are_panels_due();
    void begin_panels();
    /// The number of frames of the panels so far.
    long frame_number() const { return m_frame_number; }

private:
    using Clock = std::chrono::steady_clock;
    bool awaits_picture();

    const Lab& m_lab;
    const gpu::WindowEvents& m_events;
    const Toolkit& m_toolkit;
    Clock::time_point m_updated = Clock::now();
    Clock::time_point m_drawn = m_updated;
    Clock::time_point m_awake_until;
    Clock::time_point m_attended_until;
    long m_frame_number = 0;
    bool m_has_had_picture = false;  // a look has been drawn
};
