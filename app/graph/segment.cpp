#include "graph/segment.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
constexpr float nearly = 1e-3f;  // times that were taken from rounded ages

bool is_finite(const BeamPoint& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.intensity) &&
           std::isfinite(point.age_seconds);
}

// The charge at the start, were it laid down as long as on this way: that of `from` was laid down
// on its own way, `seconds_before` long, and charges of points that come unevenly cannot be
// compared.
float start_charge(const BeamPoint& from, const BeamPoint& to, float seconds_before) {
    const float seconds = from.age_seconds - to.age_seconds;
    if (from.intensity == 0.0f || !(seconds_before > 0.0f) || !(seconds > 0.0f))
        return to.intensity;
    const float times = seconds / seconds_before;
    if (std::abs(times - 1.0f) < nearly)
        return from.intensity;
    const float charge = from.intensity * times;
    return std::abs(charge - to.intensity) < nearly * to.intensity ? to.intensity : charge;
}

double seconds_of(const Segment& segment) {
    return static_cast<double>(segment.start_age) - static_cast<double>(segment.end_age);
}

/// Segments that may become one: evenly lit, each beginning where and when the last one ended.
class StraightRun {
public:
    StraightRun(const Segment& first, BeamTint tint) : m_joined(first), m_tint(tint) {
        m_charge = static_cast<double>(first.end_intensity);
        leave_joint();
    }

    const Segment& joined() const { return m_joined; }
    const BeamTint& tint() const { return m_tint; }

    /// Whether it was taken in.
    bool take(const Segment& next, const BeamTint& tint) {
        if (!(tint == m_tint) || !is_even(next) || !is_even(m_joined) || !follows(next))
            return false;
        const double charge = m_charge + static_cast<double>(next.end_intensity);
        const std::array<double, 2> pace{(next.x1 - from(0)) / charge,
                                         (next.y1 - from(1)) / charge};
        for (std::size_t axis = 0; axis < 2; ++axis)
            if (!(pace[axis] >= m_slowest[axis] && pace[axis] <= m_fastest[axis]))
                return false;
        m_charge = charge;
        m_joined.x1 = next.x1;
        m_joined.y1 = next.y1;
        m_joined.end_age = next.end_age;
        m_joined.start_intensity = m_joined.end_intensity = static_cast<float>(charge);
        leave_joint();
        return true;
    }

private:
    static bool is_even(const Segment& segment) {
        return segment.start_intensity == segment.end_intensity && segment.end_intensity > 0.0f;
    }

    // The same place, instant and current; ages are rounded.
    bool follows(const Segment& next) const {
        if (next.x0 != m_joined.x1 || next.y0 != m_joined.y1 || next.start_age != m_joined.end_age)
            return false;
        constexpr double rounding = 2.5e-7;
        const double expected =
            seconds_of(m_joined) * static_cast<double>(next.end_intensity) / m_charge;
        return std::abs(seconds_of(next) - expected) <=
               rounding * static_cast<double>(m_joined.start_age);
    }

    double from(std::size_t axis) const {
        return static_cast<double>(axis == 0 ? m_joined.x0 : m_joined.y0);
    }

    // The way goes by the charge, which is exact, as that of time: paces that bring the beam past
    // this end near enough are those between two.
    void leave_joint() {
        constexpr double near = 2e-6;
        const std::array<float, 2> end{m_joined.x1, m_joined.y1};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double way = static_cast<double>(end[axis]) - from(axis);
            m_slowest[axis] = std::max(m_slowest[axis], (way - near) / m_charge);
            m_fastest[axis] = std::min(m_fastest[axis], (way + near) / m_charge);
        }
    }

    Segment m_joined;
    BeamTint m_tint;
    double m_charge;
    // Half screens for a charge of 1.
    std::array<double, 2> m_slowest{-HUGE_VAL, -HUGE_VAL};
    std::array<double, 2> m_fastest{HUGE_VAL, HUGE_VAL};
};
}  // namespace

void join_straight(std::vector<Segment>& segments, SegmentTints& tints) {
    if (segments.empty())
        return;
    const bool has_tints = !tints.of_segments.empty();
    const auto tint = [&](std::size_t i) { return has_tints ? tints.of_segments[i] : BeamTint{}; };
    std::size_t count = 0;
    const auto keep = [&](const StraightRun& run) {
        segments[count] = run.joined();
        if (has_tints)
            tints.of_segments[count] = run.tint();
        ++count;
    };
    StraightRun run(segments.front(), tint(0));
    for (std::size_t i = 1; i < segments.size(); ++i)
        if (!run.take(segments[i], tint(i))) {
            keep(run);
            run = StraightRun(segments[i], tint(i));
        }
    keep(run);
    segments.resize(count);
    if (has_tints)
        tints.of_segments.resize(count);
}

void make_segments(std::span<const BeamPoint> beam, const std::optional<BeamPoint>& before,
                   std::vector<Segment>& segments, SegmentTints& tints) {
    segments.clear();
    tints.of_segments.clear();
    const BeamPoint* last = before ? &*before : nullptr;
    float seconds_before = 0.0f;  // from the point before the last one to it; 0: not known
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
