#pragma once

#include "model/plan/beam.h"

#include <optional>
#include <span>
#include <vector>

/// One instance of a `segments` pass: the path of the beam from one point to the next.
struct Segment {
    float x0, y0, x1, y1;                  // the attribute `segment`
    float start_intensity, end_intensity;  // `intensities`
    float start_age, end_age;              // `ages_seconds`, before the frame's end

    bool operator==(const Segment&) const = default;
};

/// Rounding error of a time difference between two float ages, relative to the older age.
constexpr float age_rounding = 2.5e-7f;

/// The colours of the beam's points, if it has any, and of its segments. A segment has the colour
/// of its end point.
struct SegmentTints {
    std::span<const BeamTint> of_points;
    std::vector<BeamTint> of_segments;
};

/// Connects consecutive points, the first one to `before`. If the current is known at both ends of
/// a segment, it is interpolated linearly; otherwise it is that of the end. To a point of intensity
/// 0 the beam is blanked and not drawn. From such a point it has the intensity of the end. Points
/// that are not finite are skipped, and the beam is blanked around them.
void make_segments(std::span<const BeamPoint> beam, const std::optional<BeamPoint>& before,
                   std::vector<Segment>& segments, SegmentTints& tints);
