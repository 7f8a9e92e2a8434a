#pragma once

#include "signals/drawing/stroke_line.h"

/// Two lines with the same number of points, for interpolation.
struct LineMorph {
    std::vector<BeamPosition> from;
    std::vector<BeamPosition> to;

    /// The line at `share`, 0..1; each point is interpolated linearly.
    std::vector<BeamPosition> at(double share) const;
};

/// Matches points at the same fraction of their line's length. Both lines keep all their corners.
/// Closed lines are rotated or reversed for the smallest distance.
LineMorph morph_of(const Stroke& from, const Stroke& to);

/// Matches strokes in order. When one keyframe has more strokes, those without a match are chosen
/// for the smallest total distance. They grow from a point at their own centre, or shrink to it.
std::vector<LineMorph> morphs_of(const Keyframe& from, const Keyframe& to);
