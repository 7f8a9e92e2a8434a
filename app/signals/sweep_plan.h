#pragma once

#include "signals/upsampler.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

/// Where in its sweep an up-sampled sample lies.
struct SweepPlace {
    std::int64_t place = 0;   // from 0
    bool is_waiting = false;  // for the next trigger, beam off
};

/// When the sweeps of a sound begin.
class SweepPlan {
public:
    /// Sweeps of `length` samples, one straight after the other.
    explicit SweepPlan(std::int64_t length) : m_length(length) {}

    /// Sweeps that begin where `level` of the sound rises through 0 (between two samples by a
    /// straight line), or at once where it does not do so for `patience` of its samples.
    static SweepPlan triggered(const Upsampler& sound, std::int64_t length, std::int64_t patience,
                               const std::function<float(StereoSample)>& level);

    std::int64_t length() const { return m_length; }
    /// Of an up-sampled sample; samples are asked for in rising order, `hint` begins as 0.
    SweepPlace place_of(std::int64_t sample, std::size_t& hint) const;

private:
    std::int64_t m_length;
    std::int64_t m_period = 0;           // the sound's up-sampled length; 0: no trigger
    std::vector<std::int64_t> m_starts;  // rising, the first one 0 or later
};
