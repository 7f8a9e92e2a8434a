#pragma once

#include "model/plan/beam.h"

#include <optional>
#include <span>
#include <vector>

/// One instance of a `segments` pass: the beam's way from one point to the next.
struct Segment {
    float x0, y0, x1, y1;                  // the attribute `segment`
    float start_intensity, end_intensity;  // `intensities`
    float start_age, end_age;              // `ages_seconds`, before the frame's end

    bool operator==(const Segment&) const = default;
};

/// How wrong the time between two points may be that is told by their ages, floats: of the older
/// age.
constexpr float age_rounding = 2.5e-7f;

/// The colours of a beam's points, if it has any, and those of its segments: on the way to a point
/// the beam has the point's.
struct SegmentTints {
    std::span<const BeamTint> of_points;
    std::vector<BeamTint> of_segments;
};

/// Joins consecutive points, the first one to `before`. Along a segment the current goes evenly
/// from that at its first point to that at its second, where both are known; else it is the
/// second's. Towards a point of intensity 0 the beam is blanked and nothing is drawn; from one it
/// is lit as where it goes. Points that are not finite are passed over, the beam being blanked
/// around them.
void make_segments(std::span<const BeamPoint> beam, const std::optional<BeamPoint>& before,
                   std::vector<Segment>& segments, SegmentTints& tints);
