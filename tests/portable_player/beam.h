#pragma once

#include "portable_player/signal.h"

#include <array>
#include <optional>
#include <vector>

/// The vertices of a `points` pass: the attributes position, intensity, age_seconds.
struct PointVertex {
    float x, y, charge, age;
};

/// An instance of a `segments` pass: the attributes segment, intensities, ages_seconds.
struct SegmentVertex {
    float x0, y0, x1, y1;
    float start_charge, end_charge;
    float start_age, end_age;
};

/// The beam of one frame after the other.
class Beam {
public:
    /// `scale`: factors of x and y, which fit the signal into the picture.
    Beam(const Signal& signal, const std::array<double, 2>& scale);

    void advance(double start, double end);

    const std::vector<PointVertex>& points() const { return m_points; }
    const std::vector<SegmentVertex>& segments() const { return m_segments; }

private:
    const Signal& m_signal;
    std::array<double, 2> m_scale;
    std::optional<BeamPoint> m_last;  // of the previous frames
    std::vector<PointVertex> m_points;
    std::vector<SegmentVertex> m_segments;
};

/// The factors for the setting `fit` of a signal: docs/portable.md, "Fit of a signal".
std::array<double, 2> beam_scale(const Description& description, const Size& size);
