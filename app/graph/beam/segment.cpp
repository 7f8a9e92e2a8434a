#include "graph/beam/segment.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr float nearly = 1e-3f;  // relative tolerance for equal charges and times

bool is_finite(const BeamPoint& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.intensity) &&
           std::isfinite(point.age_seconds);
}

// The charge at the start, scaled to the duration of this segment. The charge of `from` belongs to
// the previous segment, which took `seconds_before`. Without scaling, charges of unevenly spaced
// points are not comparable.
float start_charge(const BeamPoint& from, const BeamPoint& to, float seconds_before) {
    const float seconds = from.age_seconds - to.age_seconds;
    if (from.intensity == 0.0f || !(seconds_before > 0.0f) || !(seconds > 0.0f))
        return to.intensity;
    const float doubt = age_rounding * (from.age_seconds + seconds_before);
    if (std::abs(seconds - seconds_before) <= nearly * seconds_before + doubt)
        return from.intensity;
    const float charge = from.intensity * (seconds / seconds_before);
    const float same = nearly * to.intensity + charge * doubt / std::min(seconds, seconds_before);
    return std::abs(charge - to.intensity) <= same ? to.intensity : charge;
}

}  // namespace

void make_segments(std::span<const BeamPoint> beam, const std::optional<BeamPoint>& before,
                   std::vector<Segment>& segments, SegmentTints& tints) {
    segments.clear();
    tints.of_segments.clear();
    const BeamPoint* last = before ? &*before : nullptr;
    float seconds_before = 0.0f;  // duration of the previous segment; 0: unknown
    for (const BeamPoint& point : beam) {
        const bool is_good = is_finite(point);
        if (is_good && last && point.intensity != 0.0f) {
            segments.push_back({last->x, last->y, point.x, point.y,
                                start_charge(*last, point, seconds_before), point.intensity,
                                last->age_seconds, point.age_seconds});
            if (!tints.of_points.empty())
                tints.of_segments.push_back(
                    tints.of_points[static_cast<std::size_t>(&point - beam.data())]);
        }
        seconds_before = is_good && last ? last->age_seconds - point.age_seconds : 0.0f;
        last = is_good ? &point : nullptr;
    }
}
