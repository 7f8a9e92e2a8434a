#pragma once

#include "signals/drawing/drawing.h"

#include <optional>

/// What a hand has hold of in a keyframe: a point of a stroke, or the stroke as a whole.
struct StrokeGrip {
    std::size_t stroke = 0;
    std::optional<std::size_t> point = {};

    bool operator==(const StrokeGrip&) const = default;
};

/// The stroke whose line is nearest to a place, and not further from it than `reach`.
std::optional<std::size_t> stroke_near(const Keyframe& strokes, const BeamPlace& place,
                                       double reach);

/// The nearest point within `reach`; where there is none, the stroke whose line is.
std::optional<StrokeGrip> grip_near(const Keyframe& strokes, const BeamPlace& place, double reach);

/// What is held is moved by so much.
Keyframe with_moved(Keyframe strokes, const StrokeGrip& grip, const BeamPlace& by);

/// The point that is held is gone: its stroke goes on without it, and goes with it where fewer than
/// two would be left. Two that are left are no longer closed.
Keyframe without_point(Keyframe strokes, const StrokeGrip& grip);
