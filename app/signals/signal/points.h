#pragma once

#include "model/plan/beam.h"
#include "signals/signal/clock.h"
#include "signals/signal/signal_kind.h"

#include <algorithm>
#include <cstdint>
#include <limits>

/// The charge of one point at full current, with `rate` points per second. See
/// BeamPoint::intensity.
inline double charge_of_point(double rate) {
    return 4096.0 * 60.0 / rate;
}

/// Points at a constant rate.
struct PointStream {
    double rate = 4096.0 * 60.0;                                    // points per second
    std::int64_t count = std::numeric_limits<std::int64_t>::max();  // total
};

/// Appends a point for each instant of the stream in the span. `point_at(k)` returns position and
/// intensity and is called with increasing k.
template <class PointAt>
void trace_points(const TimeSpan& span, const PointStream& stream, Beam& beam,
                  const PointAt& point_at) {
    const SampleRange samples = samples_in(span, stream.rate);
    const std::int64_t end = std::min(samples.end, stream.count);
    if (end <= samples.first)
        return;
    const double seconds_per_point = 1.0 / stream.rate;
    std::size_t index = beam.size();
    beam.resize(index + static_cast<std::size_t>(end - samples.first));
    for (std::int64_t k = samples.first; k < end; ++k) {
        BeamPoint point = point_at(k);
        const double age = span.end - static_cast<double>(k + 1) * seconds_per_point;
        point.age_seconds = static_cast<float>(std::max(age, 0.0));
        beam[index++] = point;
    }
}

/// A point of a trace that is drawn repeatedly from left to right.
struct SweepPoint {
    double across = 0.0;  // 0 left .. 1 right
    float x = 0.0f;
    float intensity = 0.0f;  // 0 on the first point: the retrace is blanked
};

/// Point `index` (from 0) of a sweep of `length` points with a total charge of length * charge.
inline SweepPoint sweep_point(std::int64_t index, std::int64_t length, double charge) {
    const auto points = static_cast<double>(length);
    const double across = static_cast<double>(index + 1) / points;
    const double light = index == 0 ? 0.0 : charge * points / (points - 1.0);
    return {across, static_cast<float>(2.0 * across - 1.0), static_cast<float>(light)};
}

/// The setting for the number of points along a generator's path.
inline SettingInfo points_setting() {
    return {.key = "points",
            .label = "Points",
            .unit = "per 1/60 s",
            .help = "Number of points along the path. The brightness stays the same.",
            .low = 256,
            .high = 262144,
            .step = 1,
            .initial = 4096,
            .logarithmic = true,
            .limit = {16, 262144}};
}

inline SettingInfo amplitude_setting(double initial) {
    return {.key = "amplitude",
            .label = "Amplitude",
            .unit = "half screens",
            .help = "Maximum deflection. 1 reaches the edge.",
            .low = 0,
            .high = 1,
            .initial = initial,
            .limit = {0, 10}};
}
