#pragma once

#include "signals/audio/sound_input.h"

#include <array>
#include <optional>

/// Detects beats: blocks of 10 ms whose bass is louder than the mean of the last second, the
/// first one after 0.2 s without any. After F. Patin, "Beat Detection Algorithms", 2003, with a
/// low-pass filter first. Each beat depends only on the 1.3 s before it.
class BeatDetector {
public:
    /// Reads the left input, which must outlive this object. `threshold`: energy relative to the
    /// mean.
    BeatDetector(const SoundInput& input, double threshold);

    /// The time at which the last beat was detected; nullopt when it is more than 2 s ago.
    std::optional<double> last_beat(double seconds) const;

private:
    template <class T>
    struct Known {
        std::int64_t block = INT64_MIN;
        T value{};
    };
    template <class T>
    using Memory = std::array<Known<T>, 1024>;  // by block number; keeps the latest

    double energy(std::int64_t block) const;
    bool is_loud(std::int64_t block) const;
    bool is_beat(std::int64_t block) const;

    double m_rate;
    double m_threshold;
    LowPass m_bass;
    mutable std::vector<StereoSample> m_samples;
    mutable Memory<double> m_energies;
    mutable Memory<bool> m_loud;
};
