#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>

/// An envelope follower with one time constant for attack and one for release. It works in
/// stretches of 10 ms. Each second it restarts from silence, far enough back. The result therefore
/// depends on previous peaks only, not on the division into frames.
class Envelopes {
public:
    static constexpr double blocks_per_second = 100.0;
    /// The peak of the stretch [n, n + 1) / 100 s, n >= 0. Called after the stretch has ended.
    using Peak = std::function<double(std::int64_t stretch)>;

    explicit Envelopes(Peak peak) : m_peak(std::move(peak)) {}

    /// Value after the last complete stretch. Time constants in seconds.
    double at(double seconds, double attack, double release) const;

private:
    struct State {
        std::int64_t next = -1;  // the stretch to process next
        double level = 0.0;
    };
    struct Known {
        std::int64_t stretch = -1;
        double peak = 0.0;
    };

    double peak_of(std::int64_t stretch) const;

    Peak m_peak;
    mutable std::array<Known, 4096> m_peaks{};  // by stretch number; keeps the latest
    mutable std::map<std::pair<double, double>, State> m_states;  // by time constants
};
