#pragma once

#include "graph/executor/executor.h"
#include "lab/rendering/pass_times.h"

#include <cstddef>
#include <vector>

/// What the latest frames cost.
class FrameTimes {
public:
    /// A frame that was drawn completely.
    struct Drawn {
        double span_seconds = 0.0;  // of the signal
        std::size_t points = 0;     // of the beam
        double wall_seconds = 0.0;  // of its drawing calls
        bool has_variant = false;   // was drawn twice
    };
    void add(Executor& picture, const Drawn& drawn);

    /// GPU times by pass as of the last frame; the driver's times are some frames old.
    const std::vector<double>& pass_milliseconds() const { return m_pass_milliseconds; }
    const PassTimes& passes() const { return m_passes; }
    /// Points of the beam in the last frame.
    std::size_t point_count() const { return m_point_count; }
    /// GPU time of the passes that draw the beam per second of the signal, smoothed; 0 if the
    /// driver reports no times.
    double beam_seconds_per_second() const { return m_beam_cost; }
    /// Smoothed wall time of a frame's drawing calls, in seconds.
    double frame_seconds() const { return m_frame_seconds; }
    /// GPU time of the last frame; 0 if the driver reports no times.
    double gpu_seconds() const { return m_gpu_seconds; }

private:
    void add_beam(const Look& look, const Drawn& drawn);

    std::vector<double> m_pass_milliseconds;
    PassTimes m_passes;
    std::size_t m_point_count = 0;
    double m_beam_cost = 0.0;
    double m_frame_seconds = 1.0 / 60.0;
    double m_gpu_seconds = 0.0;
};
