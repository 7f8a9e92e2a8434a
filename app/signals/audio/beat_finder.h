#pragma once

#include "signals/audio/sound_input.h"

#include <array>
#include <optional>

/// Finds the beats of a sound: stretches of 10 ms whose bass is louder than the mean of the last
/// second, the first one after 0.2 s without any. After F. Patin, "Beat Detection Algorithms",
/// 2003, with a low-pass before it. Each beat follows from the 1.3 s before it alone.
class BeatFinder {
public:
    /// Of the left input, which must live on. `threshold`: how many times the mean's energy.
    BeatFinder(const SoundInput& input, double threshold);

    /// When the last beat was known that is at most 2 s old at this time.
    std::optional<double> last_beat(double seconds) const;

private:
    template <class T>
    struct Known {
        std::int64_t stretch = INT64_MIN;
        T value{};
    };
    template <class T>
    using Memory = std::array<Known<T>, 1024>;  // by the stretch's number, the latest one

    double energy(std::int64_t stretch) const;
    bool is_loud(std::int64_t stretch) const;
    bool is_beat(std::int64_t stretch) const;

    double m_rate;
    double m_threshold;
    LowPass m_bass;
    mutable std::vector<StereoSample> m_samples;
    mutable Memory<double> m_energies;
    mutable Memory<bool> m_loud;
};
