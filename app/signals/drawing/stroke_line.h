#pragma once

#include "signals/drawing/drawing.h"

/// A cubic Bézier curve: start, two control points, end.
using CurveSpan = std::array<BeamPosition, 4>;

/// A smooth stroke as curves between consecutive points: centripetal Catmull-Rom. It passes through
/// every point without loops between them. Source: Yuksel, Schaefer and Keyser, "Parameterization
/// and Applications of Catmull-Rom Curves", 2011.
std::vector<CurveSpan> curve_of(const Stroke& stroke);

/// The polyline that the beam follows: the stroke's points, or its curve finely subdivided. A
/// closed stroke returns to its start.
std::vector<BeamPosition> line_of(const Stroke& stroke);

/// Simplifies an open line so that each removed point is within `tolerance` of it (Ramer 1972,
/// Douglas and Peucker 1973).
std::vector<BeamPosition> simplified(const std::vector<BeamPosition>& points, double tolerance);

double distance(const BeamPosition& a, const BeamPosition& b);
double length_of(const std::vector<BeamPosition>& line);
/// The distance of a position from the nearest point of a line.
double distance_to_line(const BeamPosition& position, const std::vector<BeamPosition>& line);
