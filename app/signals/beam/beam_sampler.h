#pragma once

#include "model/plan/beam.h"
#include "signals/signal/clock.h"

#include <limits>
#include <vector>

/// Samples the beam's position at regular instants, with linear interpolation between points.
class BeamSampler {
public:
    struct Format {
        double step = 1.0 / 48000.0;  // s of the signal between samples
        int channels = 2;             // 2: x, y; 3: also the current, 1 = full
    };

    /// After `rest_seconds` without a point the beam stays still. Before that it moves towards the
    /// next point.
    explicit BeamSampler(double rest_seconds = std::numeric_limits<double>::infinity())
        : m_rest_seconds(rest_seconds) {}

    /// The first sample is one step after this time. The beam keeps its position.
    void start_at(double seconds);
    /// Appends the samples that the points of the span determine.
    void take(const TimeSpan& span, const Beam& beam, const Format& format,
              std::vector<float>& samples);
    /// Appends one more sample of the stationary beam.
    void rest(const Format& format, std::vector<float>& samples);

private:
    /// State of the beam at one instant.
    struct Instant {
        double time = 0.0;
        double x = 0.0;
        double y = 0.0;
        double current = 0.0;  // on the way to this position
    };

    void go_to(const Instant& next, const Format& format, std::vector<float>& samples);

    double m_rest_seconds;
    double m_sampled = 0.0;  // time of the last sample
    Instant m_last;
};
