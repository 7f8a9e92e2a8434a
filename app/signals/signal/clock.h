#pragma once

#include <cstdint>

/// The span (start, end] of time that a frame covers, in seconds of the signal.
struct TimeSpan {
    double start = 0.0;
    double end = 0.0;

    bool operator==(const TimeSpan&) const = default;
    double seconds() const { return end - start; }
};

/// Frame n (from 1) of a fixed clock: ((n - 1) / fps, n / fps].
TimeSpan frame_span(std::int64_t frame, double fps);

/// A range of sample numbers from 0: first .. end - 1.
struct SampleRange {
    std::int64_t first = 0;
    std::int64_t end = 0;

    std::int64_t count() const { return end - first; }
};

/// The samples of a stream whose instants lie in the span. Sample k has the instant (k + 1) / rate.
/// Adjoining spans share no sample and skip none, even when their common end was computed in two
/// ways that differ by rounding.
SampleRange samples_in(const TimeSpan& span, double rate);
