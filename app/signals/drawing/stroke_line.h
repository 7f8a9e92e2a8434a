#pragma once

#include "signals/drawing/drawing.h"

/// A cubic Bézier curve: where it begins, its two handles, where it ends.
using CurveSpan = std::array<BeamPlace, 4>;

/// A smooth stroke as curves from each of its points to the next: centripetal Catmull-Rom (Yuksel,
/// Schaefer and Keyser, "Parameterization and Applications of Catmull-Rom Curves", 2011), which
/// goes through every point and makes no loops between them.
std::vector<CurveSpan> curve_of(const Stroke& stroke);

/// What the beam follows: the stroke's points, or its curve cut so finely that it looks round; back
/// to its beginning where it is closed.
std::vector<BeamPlace> line_of(const Stroke& stroke);

/// The points of an open line that are needed so that none of the others lies further from it than
/// `tolerance` (Ramer 1972, Douglas and Peucker 1973).
std::vector<BeamPlace> simplified(const std::vector<BeamPlace>& points, double tolerance);

double distance(const BeamPlace& a, const BeamPlace& b);
double length_of(const std::vector<BeamPlace>& line);
/// How far a place is from the nearest of a line.
double distance_to_line(const BeamPlace& place, const std::vector<BeamPlace>& line);
