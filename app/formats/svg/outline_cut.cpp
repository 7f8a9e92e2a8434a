#include "formats/svg/outline_cut.h"

#include <algorithm>
#include <cmath>

namespace {
double cross(const ScenePoint& a, const ScenePoint& b) {
    return a.x * b.y - a.y * b.x;
}

ScenePoint minus(const ScenePoint& a, const ScenePoint& b) {
    return {a.x - b.x, a.y - b.y};
}

ScenePoint between(const ScenePoint& a, const ScenePoint& b, double t) {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

double length_of(const ScenePoint& a, const ScenePoint& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

double distance_to_edge(const ScenePoint& point, const ScenePoint& a, const ScenePoint& b) {
    const ScenePoint edge = minus(b, a);
    const double square = edge.x * edge.x + edge.y * edge.y;
    const ScenePoint to = minus(point, a);
    const double along =
        square > 0.0 ? std::clamp((to.x * edge.x + to.y * edge.y) / square, 0.0, 1.0) : 0.0;
    return length_of(point, between(a, b, along));
}

/// Visits each edge of a region, including the closing edge of each ring.
template <class Visit>
void each_edge(const ClipRegion& region, std::size_t& tests, Visit visit) {
    for (const ScenePath& ring : region.rings)
        for (std::size_t i = 0; i < ring.points.size() && tests > 0; ++i, --tests)
            visit(ring.points[i], ring.points[(i + 1) % ring.points.size()]);
}

bool lies_in(const ScenePoint& point, const ClipRegion& region, double tolerance,
             std::size_t& tests) {
    int winding = 0;
    int crossings = 0;
    bool is_on_edge = false;
    each_edge(region, tests, [&](const ScenePoint& a, const ScenePoint& b) {
        is_on_edge = is_on_edge || distance_to_edge(point, a, b) <= tolerance;
        if ((a.y <= point.y) == (b.y <= point.y))
            return;
        const bool is_upward = a.y <= point.y;
        if ((cross(minus(b, a), minus(point, a)) > 0.0) == is_upward) {
            winding += is_upward ? 1 : -1;
            ++crossings;
        }
    });
    return is_on_edge || (region.is_even_odd ? crossings % 2 != 0 : winding != 0);
}

// The intersections of a segment with the edges of the regions, from 0 to 1.
std::vector<double> cuts_of(const ScenePoint& from, const ScenePoint& to,
                            const std::vector<const ClipRegion*>& regions, std::size_t& tests) {
    std::vector<double> cuts{0.0, 1.0};
    const ScenePoint way = minus(to, from);
    for (const ClipRegion* region : regions)
        each_edge(*region, tests, [&](const ScenePoint& a, const ScenePoint& b) {
            const ScenePoint edge = minus(b, a);
            const double scale = cross(way, edge);
            if (scale == 0.0)
                return;
            const double t = cross(minus(a, from), edge) / scale;
            const double u = cross(minus(a, from), way) / scale;
            if (t > 0.0 && t < 1.0 && u >= 0.0 && u <= 1.0)
                cuts.push_back(t);
        });
    std::ranges::sort(cuts);
    return cuts;
}

/// Joins consecutive segments.
class Pieces {
public:
    void add(const ScenePoint& from, const ScenePoint& to, bool follows) {
        if (!follows || m_open.points.empty()) {
            end();
            m_open.points.push_back(from);
        }
        m_open.points.push_back(to);
    }
    void end() {
        if (m_open.points.size() > 1)
            m_done.push_back(std::move(m_open));
        m_open = {};
    }
    std::vector<ScenePath> take() {
        end();
        return std::move(m_done);
    }
    std::size_t size() const { return m_done.size(); }

private:
    ScenePath m_open;
    std::vector<ScenePath> m_done;
};
}  // namespace

std::vector<ScenePath> clipped(const ScenePath& path, const std::vector<const ClipRegion*>& regions,
                               double tolerance, std::size_t& tests) {
    if (regions.empty())
        return {path};
    Pieces pieces;
    bool follows = false;
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
        const ScenePoint& from = path.points[i];
        const ScenePoint& to = path.points[i + 1];
        const std::vector<double> cuts = cuts_of(from, to, regions, tests);
        double begin = 0.0;  // start of the current visible part
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            const ScenePoint middle = between(from, to, 0.5 * (cuts[k] + cuts[k + 1]));
            const bool is_seen = std::ranges::all_of(regions, [&](const ClipRegion* region) {
                return lies_in(middle, *region, tolerance, tests);
            });
            if (!is_seen && begin < cuts[k])
                pieces.add(between(from, to, begin), between(from, to, cuts[k]),
                           follows && begin == 0.0);
            if (!is_seen)
                begin = cuts[k + 1];
        }
        if (begin < 1.0)
            pieces.add(between(from, to, begin), to, follows && begin == 0.0);
        follows = begin < 1.0;
    }
    return pieces.take();
}

std::vector<ScenePath> dashed(const ScenePath& path, std::vector<double> lengths, double offset,
                              std::size_t maximum) {
    double period = 0.0;
    for (const double length : lengths)
        period += length;
    const bool is_solid = std::ranges::any_of(lengths, [](double length) { return length < 0.0; });
    if (lengths.empty() || is_solid || !(period > 0.0) || !std::isfinite(period))
        return {path};
    if (lengths.size() % 2 != 0) {
        lengths.insert(lengths.end(), lengths.begin(), lengths.end());
        period *= 2.0;
    }
    double left = std::fmod(std::fmod(offset, period) + period, period);
    std::size_t at = 0;
    for (; left >= lengths[at]; at = (at + 1) % lengths.size())
        left -= lengths[at];
    left = lengths[at] - left;
    Pieces pieces;
    bool follows = false;
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
        const double whole = length_of(path.points[i], path.points[i + 1]);
        for (double gone = 0.0; gone < whole;) {
            const double step = std::min(left, whole - gone);
            const bool is_dash = at % 2 == 0;
            if (is_dash)
                pieces.add(between(path.points[i], path.points[i + 1], gone / whole),
                           between(path.points[i], path.points[i + 1], (gone + step) / whole),
                           follows);
            gone += step;
            left -= step;
            follows = is_dash;
            if (left <= 0.0) {
                at = (at + 1) % lengths.size();
                left = lengths[at];
                follows = false;
            }
            if (pieces.size() > maximum || (step <= 0.0 && left <= 0.0 && period < 1e-9 * whole))
                return {path};
        }
    }
    return pieces.take();
}
