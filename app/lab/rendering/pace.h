#pragma once

#include <array>
#include <cstddef>

/// How evenly the window's frames come: the wall time between the latest of them.
class Pace {
public:
    static constexpr std::size_t length = 240;

    /// A pause longer than a second (a resting window) is no frame, unless one was drawn all the
    /// while.
    void add(double wall_seconds, bool was_busy = false);
    /// The same frame, and whether it was to come sooner than in 1/30 s.
    void expect(double wall_seconds, bool is_due);

    /// Milliseconds, oldest first from start(), wrapping round.
    const std::array<float, length>& milliseconds() const { return m_milliseconds; }
    std::size_t start() const { return m_next; }
    /// Over about the last half second; 0 while resting.
    double frames_a_second() const { return m_seconds > 0.0 ? 1.0 / m_seconds : 0.0; }
    /// For two seconds no frame has come within 1/30 s.
    bool is_slow() const { return m_slow_seconds >= 2.0; }
    /// And the picture's passes, which take so long, take at least half of each frame: else a
    /// smaller picture would not help much.
    bool is_slow_by_passes(double pass_milliseconds) const {
        return is_slow() && pass_milliseconds >= 0.5 * m_slow_milliseconds;
    }

private:
    std::array<float, length> m_milliseconds{};
    std::size_t m_next = 0;
    double m_seconds = 0.0;            // smoothed
    double m_slow_seconds = 0.0;       // since a frame came in time
    double m_slow_milliseconds = 0.0;  // of such a frame, smoothed
};
