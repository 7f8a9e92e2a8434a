#pragma once

#include "signals/signal/stereo_sample.h"

#include <cstdint>
#include <functional>
#include <span>

/// A first-order low-pass filter, like an RC circuit. Each value depends only on the samples before
/// it, not on how the stream is divided.
class LowPass {
public:
    using Read = std::function<void(std::int64_t first, std::span<StereoSample> samples)>;

    /// `rate` in samples per second; -3 dB at `hertz`.
    LowPass(double rate, double hertz, Read read);

    /// The filtered samples first, first + 1, ...
    void read(std::int64_t first, std::span<StereoSample> slow) const;

private:
    void prime(std::int64_t sample) const;
    void follow(StereoSample sample) const;

    Read m_read;
    std::int64_t m_block;                     // samples after which the state is recomputed
    std::int64_t m_memory = 0;                // samples of history for this
    float m_pull = 0.0f;                      // fraction by which a sample moves the state
    mutable std::int64_t m_next = INT64_MIN;  // the sample that m_state precedes
    mutable StereoSample m_state;
};
