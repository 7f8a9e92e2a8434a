#pragma once

#include "model/plan/beam.h"
#include "signals/signal/clock.h"

#include <limits>
#include <vector>

/// Tells where the beam is at even instants, on the straight way from point to point.
class BeamSampler {
public:
    struct Format {
        double step = 1.0 / 48000.0;  // s of the signal from one sample to the next
        int channels = 2;             // 2: x, y; 3: the current, too, 1 full
    };

    /// Where no point comes for so long the beam rests; otherwise it is on its way to the next one.
    explicit BeamSampler(double rest_seconds = std::numeric_limits<double>::infinity())
        : m_rest_seconds(rest_seconds) {}

    /// The first sample is one step after this time. The beam stays where it was.
    void start_at(double seconds);
    /// Appends what the points of the span tell of the next samples.
    void take(const TimeSpan& span, const Beam& beam, const Format& format,
              std::vector<float>& samples);
    /// Appends one more sample, of the beam at rest.
    void rest(const Format& format, std::vector<float>& samples);

private:
    /// The beam at one instant.
    struct Instant {
        double time = 0.0;
        double x = 0.0;
        double y = 0.0;
        double current = 0.0;  // on the way to it
    };

    void go_to(const Instant& next, const Format& format, std::vector<float>& samples);

    double m_rest_seconds;
    double m_sampled = 0.0;  // time of the last sample
    Instant m_last;
};
