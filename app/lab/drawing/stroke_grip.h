#pragma once

#include "signals/drawing/drawing.h"

#include <optional>

/// The point or whole stroke of a keyframe that can be dragged.
struct StrokeGrip {
    std::size_t stroke = 0;
    std::optional<std::size_t> point = {};

    bool operator==(const StrokeGrip&) const = default;
};

/// The stroke with the nearest line within `reach` of a position.
std::optional<std::size_t> stroke_near(const Keyframe& strokes, const BeamPosition& position,
                                       double reach);

/// The nearest point within `reach`, otherwise the nearest stroke within `reach`.
std::optional<StrokeGrip> grip_near(const Keyframe& strokes, const BeamPosition& position,
                                    double reach);

/// Moves the point or stroke by an offset.
Keyframe with_moved(Keyframe strokes, const StrokeGrip& grip, const BeamPosition& by);

/// Deletes a point. A stroke with fewer than two remaining points is deleted. A closed stroke with
/// only two remaining points is opened.
Keyframe without_point(Keyframe strokes, const StrokeGrip& grip);
