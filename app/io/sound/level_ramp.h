#pragma once

#include <atomic>
#include <span>

/// A volume that one thread sets and the device's thread applies.
class LevelRamp {
public:
    LevelRamp(double goal, double now) : m_goal(goal), m_now(now) {}

    void set(double level) { m_goal = level; }

    /// Scales interleaved left and right samples and clamps them to -1 .. 1. A new level is reached
    /// over their length, so that nothing clicks. Call it on the device's thread.
    void apply(std::span<float> stereo) noexcept;

private:
    std::atomic<double> m_goal;
    double m_now;  // of the device's thread
};
