#include "graph/beam/merge_segments.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
using Axes = std::array<double, 2>;  // x, y; in half screens

/// The tolerance of the beam's position on each axis: squares around the joints that lie in circles
/// of 0.01 and 0.05 of the spot.
struct Freedom {
    static constexpr double minimum = 2e-6;

    explicit Freedom(const BeamSpot& spot)
        : of_long{std::max(0.007 * spot.across, minimum), std::max(0.007 * spot.up, minimum)},
          of_short{std::max(0.035 * spot.across, minimum), std::max(0.035 * spot.up, minimum)},
          longest_short{0.5 * spot.across, 0.5 * spot.up},
          current(spot.across > 0.0 && spot.up > 0.0 ? 0.005 : 0.0) {}

    Axes of_long;
    Axes of_short;
    Axes longest_short;
    double current;  // tolerance, relative to the run's current, in both directions
};

/// The range of velocities, in half screens per charge of 1, that pass all joints within the
/// tolerance.
struct Paces {
    Axes slowest{-HUGE_VAL, -HUGE_VAL};
    Axes fastest{HUGE_VAL, HUGE_VAL};

    bool hold(const Axes& pace) const {
        return pace[0] >= slowest[0] && pace[0] <= fastest[0] && pace[1] >= slowest[1] &&
               pace[1] <= fastest[1];
    }
    void pass(const Axes& joint, double charge, const Axes& freedom) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            slowest[axis] = std::max(slowest[axis], (joint[axis] - freedom[axis]) / charge);
            fastest[axis] = std::min(fastest[axis], (joint[axis] + freedom[axis]) / charge);
        }
    }
};

double charge_of(const Segment& segment) {
    return 0.5 * (static_cast<double>(segment.start_intensity) +
                  static_cast<double>(segment.end_intensity));
}

double seconds_of(const Segment& segment) {
    return static_cast<double>(segment.start_age) - static_cast<double>(segment.end_age);
}

/// A run of segments that may be merged: even intensity, each starting where and when the previous
/// one ended. The position is a function of the charge, which is exact, as it is of time.
class SegmentRun {
public:
    SegmentRun(const Segment& first, BeamTint tint, const Freedom& freedom)
        : m_freedom(freedom), m_joined(first), m_tint(tint), m_charge(charge_of(first)) {
        m_is_even = is_even(first);
        leave_joint({way(first, 0), way(first, 1)});
    }

    const Segment& joined() const { return m_joined; }
    const BeamTint& tint() const { return m_tint; }

    /// Whether the segment was added.
    bool take(const Segment& next, const BeamTint& tint) {
        if (!m_is_even || !is_even(next) || !follows(next) || !(tint == m_tint))
            return false;
        const double charge = m_charge + charge_of(next);
        const Axes way_to_end{way(next, 0), way(next, 1)};
        const Axes pace{way_to_end[0] / charge, way_to_end[1] / charge};
        if (!m_long.hold(pace) && !(is_short(way_to_end) && m_short.hold(pace)))
            return false;
        m_charge = charge;
        m_joined.x1 = next.x1;
        m_joined.y1 = next.y1;
        m_joined.end_age = next.end_age;
        m_joined.start_intensity = m_joined.end_intensity = static_cast<float>(charge);
        leave_joint(way_to_end);
        return true;
    }

private:
    bool is_even(const Segment& segment) const {
        const auto start = static_cast<double>(segment.start_intensity);
        const auto end = static_cast<double>(segment.end_intensity);
        return std::abs(start - end) <= m_freedom.current * (start + end) && start > 0.0 &&
               end > 0.0;
    }

    // The same position, time and current.
    bool follows(const Segment& next) const {
        if (next.x0 != m_joined.x1 || next.y0 != m_joined.y1 || next.start_age != m_joined.end_age)
            return false;
        const double seconds = seconds_of(next);
        const double expected = seconds_of(m_joined) * charge_of(next) / m_charge;
        return std::abs(seconds - expected) <=
               static_cast<double>(age_rounding * m_joined.start_age) + m_freedom.current * seconds;
    }

    double way(const Segment& to, std::size_t axis) const {
        return axis == 0 ? static_cast<double>(to.x1) - static_cast<double>(m_joined.x0)
                         : static_cast<double>(to.y1) - static_cast<double>(m_joined.y0);
    }

    bool is_short(const Axes& way_to_end) const {
        return std::hypot(way_to_end[0] / m_freedom.longest_short[0],
                          way_to_end[1] / m_freedom.longest_short[1]) <= 1.0;
    }

    void leave_joint(const Axes& joint) {
        m_long.pass(joint, m_charge, m_freedom.of_long);
        m_short.pass(joint, m_charge, m_freedom.of_short);
    }

    Freedom m_freedom;
    Segment m_joined;
    BeamTint m_tint;
    double m_charge;
    bool m_is_even = false;
    Paces m_long;
    Paces m_short;
};
}  // namespace

void merge_segments(std::vector<Segment>& segments, SegmentTints& tints, const BeamSpot& spot) {
    if (segments.empty())
        return;
    const Freedom freedom(spot);
    const bool has_tints = !tints.of_segments.empty();
    const auto tint = [&](std::size_t i) { return has_tints ? tints.of_segments[i] : BeamTint{}; };
    std::size_t count = 0;
    const auto keep = [&](const SegmentRun& run) {
        segments[count] = run.joined();
        if (has_tints)
            tints.of_segments[count] = run.tint();
        ++count;
    };
    SegmentRun run(segments.front(), tint(0), freedom);
    for (std::size_t i = 1; i < segments.size(); ++i)
        if (!run.take(segments[i], tint(i))) {
            keep(run);
            run = SegmentRun(segments[i], tint(i), freedom);
        }
    keep(run);
    segments.resize(count);
    if (has_tints)
        tints.of_segments.resize(count);
}
