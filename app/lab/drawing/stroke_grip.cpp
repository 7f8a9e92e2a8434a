#include "lab/drawing/stroke_grip.h"

#include "signals/drawing/stroke_line.h"

std::optional<std::size_t> stroke_near(const Keyframe& strokes, const BeamPosition& position,
                                       double reach) {
    std::optional<std::size_t> found;
    double nearest = reach;
    for (std::size_t i = 0; i < strokes.size(); ++i)
        if (const double away = distance_to_line(position, line_of(strokes[i])); away <= nearest) {
            nearest = away;
            found = i;
        }
    return found;
}

std::optional<StrokeGrip> grip_near(const Keyframe& strokes, const BeamPosition& position,
                                    double reach) {
    std::optional<StrokeGrip> found;
    double nearest = reach;
    for (std::size_t i = 0; i < strokes.size(); ++i)
        for (std::size_t k = 0; k < strokes[i].points.size(); ++k)
            if (const double away = distance(position, strokes[i].points[k]); away <= nearest) {
                nearest = away;
                found = StrokeGrip{i, k};
            }
    if (!found)
        if (const auto stroke = stroke_near(strokes, position, reach))
            found = StrokeGrip{*stroke};
    return found;
}

Keyframe with_moved(Keyframe strokes, const StrokeGrip& grip, const BeamPosition& by) {
    std::vector<BeamPosition>& points = strokes[grip.stroke].points;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!grip.point || *grip.point == i)
            points[i] = {points[i][0] + by[0], points[i][1] + by[1]};
    return strokes;
}

Keyframe without_point(Keyframe strokes, const StrokeGrip& grip) {
    if (!grip.point)
        return strokes;
    Stroke& stroke = strokes[grip.stroke];
    stroke.points.erase(stroke.points.begin() + static_cast<std::ptrdiff_t>(*grip.point));
    stroke.is_closed = stroke.is_closed && stroke.points.size() > 2;
    if (stroke.points.size() < 2)
        strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(grip.stroke));
    return strokes;
}
