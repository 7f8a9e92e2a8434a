#pragma once

#include <array>
#include <cstddef>

/// The wall times between the latest frames of the window.
class Pace {
public:
    static constexpr std::size_t length = 240;

    /// Ignores a pause longer than a second (an idle window), unless a frame was drawn all the
    /// time.
    void add(double wall_seconds, bool was_busy = false);
    /// For the same frame: whether it was due within 1/30 s.
    void expect(double wall_seconds, bool is_due);
    /// Both for each update of the window. A slow frame spans many updates.
    void update(double wall_seconds, bool has_unfinished_frame, bool is_due);

    /// Milliseconds, oldest first from start(), wrapping round.
    const std::array<float, length>& milliseconds() const { return m_milliseconds; }
    std::size_t start() const { return m_next; }
    /// Over about the last half second; 0 before the first frame.
    double frames_per_second() const { return m_seconds > 0.0 ? 1.0 / m_seconds : 0.0; }
    /// Whether no frame has come within 1/30 s for two seconds.
    bool is_slow() const { return m_slow_seconds >= 2.0; }
    /// Whether it is slow and the passes take at least half of each frame. Otherwise a smaller
    /// picture would not help much.
    bool is_slow_by_passes(double pass_milliseconds) const {
        return is_slow() && pass_milliseconds >= 0.5 * m_slow_milliseconds;
    }

private:
    std::array<float, length> m_milliseconds{};
    std::size_t m_next = 0;
    double m_seconds = 0.0;            // smoothed
    double m_slow_seconds = 0.0;       // since the last frame in time
    double m_slow_milliseconds = 0.0;  // of a slow frame, smoothed
    double m_frame_seconds = 0.0;      // since the last complete frame
};
