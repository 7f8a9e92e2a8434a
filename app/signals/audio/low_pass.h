#pragma once

#include "signals/signal/stereo_sample.h"

#include <cstdint>
#include <functional>
#include <span>

/// The slow part of a stream of samples: a first-order low-pass, as a capacitor makes it. Each
/// value follows from the samples before it alone, however the stream is cut.
class LowPass {
public:
    using Read = std::function<void(std::int64_t first, std::span<StereoSample> samples)>;

    /// `rate` in samples a second; at `hertz` the output is 3 dB down.
    LowPass(double rate, double hertz, Read read);

    /// The slow part at the samples first, first + 1, ...
    void read(std::int64_t first, std::span<StereoSample> slow) const;

private:
    void settle(std::int64_t sample) const;
    void follow(StereoSample sample) const;

    Read m_read;
    std::int64_t m_block;                     // samples after which the state is found anew
    std::int64_t m_memory;                    // samples that are looked back for it
    float m_pull;                             // share of the way that a sample moves the state
    mutable std::int64_t m_next = INT64_MIN;  // the sample that the state is ready for
    mutable StereoSample m_state;
};
