#include "signals/drawing/stroke_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {
BeamPosition sum(const BeamPosition& a, double factor, const BeamPosition& b) {
    return {a[0] + factor * b[0], a[1] + factor * b[1]};
}

// Two equal points have no direction.
std::vector<BeamPosition> without_repeats(const Stroke& stroke) {
    std::vector<BeamPosition> points;
    for (const BeamPosition& point : stroke.points)
        if (points.empty() || point != points.back())
            points.push_back(point);
    while (stroke.is_closed && points.size() > 1 && points.front() == points.back())
        points.pop_back();
    return points;
}

// The curve from b to c through a, b, c, d. The derivatives at b and c depend on the knot spacing,
// the square root of the distance.
CurveSpan span_of(const BeamPosition& a, const BeamPosition& b, const BeamPosition& c,
                  const BeamPosition& d) {
    const double before = std::sqrt(distance(a, b));
    const double here = std::sqrt(distance(b, c));
    const double after = std::sqrt(distance(c, d));
    CurveSpan span{b, b, c, c};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double slope = (c[axis] - b[axis]) / here;
        const double at_b = (b[axis] - a[axis]) / before - (c[axis] - a[axis]) / (before + here);
        const double at_c = (d[axis] - c[axis]) / after - (d[axis] - b[axis]) / (here + after);
        span[1][axis] = b[axis] + here * (at_b + slope) / 3.0;
        span[2][axis] = c[axis] - here * (at_c + slope) / 3.0;
    }
    return span;
}

BeamPosition position_on(const CurveSpan& span, double t) {
    const double s = 1.0 - t;
    const double weights[4] = {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
    BeamPosition position{};
    for (std::size_t i = 0; i < 4; ++i)
        position = sum(position, weights[i], span[i]);
    return position;
}

double distance_to_piece(const BeamPosition& position, const BeamPosition& from,
                         const BeamPosition& to) {
    const BeamPosition way = sum(to, -1.0, from);
    const BeamPosition out = sum(position, -1.0, from);
    const double square = way[0] * way[0] + way[1] * way[1];
    const double share = square > 0.0 ? (out[0] * way[0] + out[1] * way[1]) / square : 0.0;
    return distance(position, sum(from, std::clamp(share, 0.0, 1.0), way));
}
}  // namespace

double distance(const BeamPosition& a, const BeamPosition& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1]);
}

double length_of(const std::vector<BeamPosition>& line) {
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i)
        length += distance(line[i - 1], line[i]);
    return length;
}

double distance_to_line(const BeamPosition& position, const std::vector<BeamPosition>& line) {
    double nearest =
        line.empty() ? std::numeric_limits<double>::infinity() : distance(position, line.front());
    for (std::size_t i = 1; i < line.size(); ++i)
        nearest = std::min(nearest, distance_to_piece(position, line[i - 1], line[i]));
    return nearest;
}

std::vector<CurveSpan> curve_of(const Stroke& stroke) {
    const std::vector<BeamPosition> points = without_repeats(stroke);
    const std::size_t count = points.size();
    std::vector<CurveSpan> spans;
    if (count < 2)
        return spans;
    const bool is_round = stroke.is_closed && count > 2;
    const std::size_t steps = is_round ? count : count - 1;
    for (std::size_t i = 0; i < steps; ++i) {
        const BeamPosition& from = points[i];
        const BeamPosition& to = points[(i + 1) % count];
        // Extrapolates a point past each end.
        const BeamPosition before = is_round || i > 0 ? points[(i + count - 1) % count]
                                                      : sum(sum(from, 1.0, from), -1.0, to);
        const BeamPosition after =
            is_round || i + 2 < count ? points[(i + 2) % count] : sum(sum(to, 1.0, to), -1.0, from);
        spans.push_back(span_of(before, from, to, after));
    }
    return spans;
}

std::vector<BeamPosition> line_of(const Stroke& stroke) {
    constexpr double step = 0.015;  // half screens: corners of the curve are not visible
    constexpr double max_steps = 32.0;
    std::vector<BeamPosition> line = without_repeats(stroke);
    if (!stroke.is_smooth) {
        if (stroke.is_closed && line.size() > 1)
            line.push_back(line.front());
        return line;
    }
    line.resize(std::min<std::size_t>(line.size(), 1));
    for (const CurveSpan& span : curve_of(stroke)) {
        const double steps =
            std::clamp(std::ceil(distance(span[0], span[3]) / step), 2.0, max_steps);
        for (double i = 1.0; i < steps; i += 1.0)
            line.push_back(position_on(span, i / steps));
        line.push_back(span[3]);
    }
    return line;
}

std::vector<BeamPosition> simplified(const std::vector<BeamPosition>& points, double tolerance) {
    if (points.size() < 3)
        return points;
    std::vector<bool> is_kept(points.size(), false);
    is_kept.front() = is_kept.back() = true;
    std::vector<std::array<std::size_t, 2>> open{{0, points.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        std::size_t farthest = first;
        double maximum = tolerance;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double away = distance_to_piece(points[i], points[first], points[last]);
            if (away > maximum) {
                maximum = away;
                farthest = i;
            }
        }
        if (farthest == first)
            continue;
        is_kept[farthest] = true;
        open.push_back({first, farthest});
        open.push_back({farthest, last});
    }
    std::vector<BeamPosition> remaining;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (is_kept[i])
            remaining.push_back(points[i]);
    return remaining;
}
