#pragma once

#include "signals/audio/sample_stream.h"

#include <array>
#include <cstdint>

/// The gain that lets the peak of the last second of a sound just fit, at most 40 dB. It follows
/// from the sound and the place alone: peaks of blocks of 0.1 s are found ahead of time, those of a
/// live sound as soon as they are whole, so that its first loud moment may stick out.
class AutoGain {
public:
    /// Of a stream that must live on.
    explicit AutoGain(const SampleStream& sound);

    /// At a place in samples of the sound.
    float at(double place) const;

private:
    struct Peak {
        std::int64_t block = -1;
        float value = 0.0f;
    };
    float peak_of(std::int64_t block) const;
    float gain_at(std::int64_t block) const;

    const SampleStream& m_sound;
    std::int64_t m_block;                    // samples
    std::int64_t m_count;                    // of blocks
    mutable std::array<Peak, 64> m_peaks;    // the latest ones, by their number
    mutable std::int64_t m_below = -1;       // the block whose gains are known
    mutable std::array<float, 2> m_gains{};  // at its begin and end
};
