#pragma once

#include <atomic>
#include <span>

/// A loudness that one thread sets and the device's thread applies.
class LevelRamp {
public:
    LevelRamp(double goal, double now) : m_goal(goal), m_now(now) {}

    void set(double level) { m_goal = level; }

    /// Scales left and right in turn to within -1 .. 1, a new level being reached over their
    /// length, so that nothing clicks. For the device's thread.
    void apply(std::span<float> stereo) noexcept;

private:
    std::atomic<double> m_goal;
    double m_now;  // of the device's thread
};
