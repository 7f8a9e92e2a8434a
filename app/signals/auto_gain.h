#pragma once

#include "signals/upsampler.h"

#include <cstdint>
#include <vector>

/// The gain that lets the peak of the last second of a sound just fit, at most 40 dB. It follows
/// from the sound and the place alone: peaks of blocks of 0.1 s are found ahead of time.
class AutoGain {
public:
    AutoGain(const Upsampler& sound, const SoundPart& part, int rate);

    /// At a place in samples of the sound from the part's begin.
    float at(double place) const;

private:
    float peak_before(std::int64_t block) const;

    std::int64_t m_block;  // samples
    bool m_loops;
    std::vector<float> m_peaks;
    std::vector<float> m_gains;  // at the begin of each block, and at the end of the last
};
