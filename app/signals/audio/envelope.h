#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>

/// Follows the peaks of something up with one time constant and down with another. What it gives
/// follows from the peaks of the time before alone, however that is cut into frames: it goes in
/// stretches of 10 ms, and begins anew from silence each second, long enough before it.
class Envelopes {
public:
    static constexpr double stretches_a_second = 100.0;
    /// Of the stretch [n, n + 1) / 100 s, n >= 0; asked about once it has gone by.
    using Peak = std::function<double(std::int64_t stretch)>;

    explicit Envelopes(Peak peak) : m_peak(std::move(peak)) {}

    /// After the last stretch that has ended. Time constants in seconds.
    double at(double seconds, double attack, double release) const;

private:
    struct State {
        std::int64_t next = -1;  // the stretch that it is ready for
        double level = 0.0;
    };
    struct Known {
        std::int64_t stretch = -1;
        double peak = 0.0;
    };

    double peak_of(std::int64_t stretch) const;

    Peak m_peak;
    mutable std::array<Known, 4096> m_peaks{};  // by the stretch's number, the latest one
    mutable std::map<std::pair<double, double>, State> m_states;  // by the time constants
};
