#pragma once

#include "io/sound/level_ramp.h"

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

/// A queue of beam positions for a sound device, one per sample, left and right interleaved. One
/// thread writes and another calls mix(), which never waits, allocates or frees.
class BeamQueue {
public:
    /// Capacity: one second.
    explicit BeamQueue(int rate);

    int rate() const { return m_rate; }
    /// Sample frames not yet played.
    std::size_t waiting() const;
    /// Samples beyond the capacity are dropped.
    void write(std::span<const float> stereo);
    /// Discards the waiting samples. The next written samples follow without a click.
    void start_anew() { m_start = m_written.load(); }
    /// 0 .. 1; reached over the length of a buffer.
    void set_level(double level);

    /// Fills `stereo` with interleaved left and right samples within -1 .. 1. While the queue is
    /// empty the beam keeps its position; new samples are reached within 5 ms. Call it on the
    /// device's thread.
    void mix(std::span<float> stereo) noexcept;

private:
    struct Position {
        float x = 0.0f;
        float y = 0.0f;
    };
    Position next() noexcept;

    int m_rate;
    std::vector<float> m_samples;  // a ring buffer
    std::atomic<std::int64_t> m_written = 0;
    std::atomic<std::int64_t> m_start = 0;  // earlier samples are not played
    std::atomic<std::int64_t> m_read = 0;
    LevelRamp m_level{0.5, 0.0};

    // Used only by the device's thread.
    Position m_last;           // the beam's position
    Position m_away;           // offset from the target when the beam last started to move
    int m_joining = 0;         // frames until the target is reached
    bool m_has_rested = true;  // the queue was empty
};
