#pragma once

#include "io/sound/level_ramp.h"

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

/// A beam on its way to a sound device: where it is at each sample, left and right in turn. One
/// thread writes and one other calls mix(), which neither waits nor allocates nor frees.
class BeamQueue {
public:
    /// Room for a second.
    explicit BeamQueue(int rate);

    int rate() const { return m_rate; }
    /// Sample frames that are yet to be played.
    std::size_t waiting() const;
    /// What there is no room for is lost.
    void write(std::span<const float> stereo);
    /// What waits is not played. The next that is written follows without a click.
    void start_anew() { m_start = m_written.load(); }
    /// 0 .. 1; reached over the length of a buffer.
    void set_level(double level);

    /// Fills in left and right in turn, within -1 .. 1. Where nothing waits the beam rests where it
    /// is; from there it moves on within 5 ms. For the device's thread.
    void mix(std::span<float> stereo) noexcept;

private:
    struct Place {
        float x = 0.0f;
        float y = 0.0f;
    };
    Place next() noexcept;

    int m_rate;
    std::vector<float> m_samples;  // a ring
    std::atomic<std::int64_t> m_written = 0;
    std::atomic<std::int64_t> m_start = 0;  // what was written before is not played
    std::atomic<std::int64_t> m_read = 0;
    LevelRamp m_level{0.5, 0.0};

    // Of the device's thread.
    Place m_last;              // where the beam is
    Place m_away;              // from where it should be, when it last began anew
    int m_joining = 0;         // frames until it is there
    bool m_has_rested = true;  // nothing waited
};
