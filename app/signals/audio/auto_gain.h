#pragma once

#include "signals/audio/sample_stream.h"

#include <array>
#include <cstdint>

/// The gain that normalises the peak of the last second to full scale, at most 40 dB. It depends on
/// the sound and the position only. Peaks of blocks of 0.1 s are read ahead. A live sound's peaks
/// are known only when a block is complete, so its first loud moment may exceed full scale.
class AutoGain {
public:
    /// The stream must outlive this object.
    explicit AutoGain(const SampleStream& sound);

    /// At a position in samples of the sound.
    float at(double position) const;

private:
    struct Peak {
        std::int64_t block = -1;
        float value = 0.0f;
    };
    float peak_of(std::int64_t block) const;
    float gain_at(std::int64_t block) const;

    const SampleStream& m_sound;
    std::int64_t m_block;                    // samples
    std::int64_t m_count;                    // number of blocks
    mutable std::array<Peak, 64> m_peaks;    // the latest ones, by block number
    mutable std::int64_t m_below = -1;       // the block for which m_gains is valid
    mutable std::array<float, 2> m_gains{};  // at its start and end
};
