#include "graph/segment.h"

#include <cmath>

namespace {
bool is_finite(const BeamPoint& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.intensity) &&
           std::isfinite(point.age_seconds);
}

Segment join(const BeamPoint& from, const BeamPoint& to) {
    const float start = from.intensity == 0.0f ? to.intensity : from.intensity;
    return {from.x, from.y, to.x, to.y, start, to.intensity, from.age_seconds, to.age_seconds};
}
}  // namespace

void make_segments(std::span<const BeamPoint> beam, const std::optional<BeamPoint>& before,
                   std::vector<Segment>& segments) {
    segments.clear();
    const BeamPoint* last = before ? &*before : nullptr;
    for (const BeamPoint& point : beam) {
        const bool is_good = is_finite(point);
        if (is_good && last && point.intensity != 0.0f)
            segments.push_back(join(*last, point));
        last = is_good ? &point : nullptr;
    }
}
