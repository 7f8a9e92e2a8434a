#pragma once

#include "signals/drawing/stroke_line.h"

/// A line on its way to becoming another: as many points of each, which belong together.
struct LineMorph {
    std::vector<BeamPlace> from;
    std::vector<BeamPlace> to;

    /// The line when `share`, 0..1, of the way is gone: every point on a straight way.
    std::vector<BeamPlace> at(double share) const;
};

/// Points belong together that lie at the same share of their line's length. There is one wherever
/// either line has a corner, so that neither loses any. Two closed lines are turned so that they
/// have the least way to go.
LineMorph morph_of(const Stroke& from, const Stroke& to);

/// Strokes that belong together by their order. Where one keyframe has more of them, those without
/// a counterpart are chosen so that the others have the least way to go; they grow out of a point
/// in their own middle, or shrink to it.
std::vector<LineMorph> morphs_of(const Keyframe& from, const Keyframe& to);
