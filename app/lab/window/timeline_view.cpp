#include "lab/window/timeline_view.h"

#include <algorithm>
#include <array>

namespace {
constexpr double shortest_view = 0.01;  // s

// Within the length, with the same width if possible.
TimelineRange within_length(const TimelineRange& range, double length) {
    const double seconds = std::clamp(range.seconds(), std::min(shortest_view, length), length);
    const double start = std::clamp(range.start, 0.0, length - seconds);
    return {start, start + seconds};
}
}  // namespace

TimelineRange TimelineView::visible(double length) const {
    return m_range && m_range->seconds() < length ? within_length(*m_range, length)
                                                  : TimelineRange{0.0, length};
}

void TimelineView::show(double length, const TimelineRange& range) {
    if (range.seconds() >= length)
        return show_all();
    m_range = within_length(range, length);
}

void TimelineView::zoom(double length, double factor, double share) {
    const TimelineRange now = visible(length);
    const double fixed = now.time(share);
    const double seconds = std::max(now.seconds() / factor, shortest_view);
    show(length, {fixed - share * seconds, fixed + (1.0 - share) * seconds});
}

void TimelineView::pan(double length, double share) {
    const TimelineRange now = visible(length);
    const double by = share * now.seconds();
    if (m_range)
        show(length, {now.start + by, now.end + by});
}

void TimelineView::follow(double length, double position) {
    const TimelineRange now = visible(length);
    if (!m_range || drag || (position >= now.start && position < now.end))
        return;
    show(length, {position, position + now.seconds()});
}

double label_step(double seconds, double count) {
    constexpr std::array steps{0.001, 0.002, 0.005, 0.01,  0.02,   0.05,  0.1,  0.2,
                               0.5,   1.0,   2.0,   5.0,   10.0,   15.0,  30.0, 60.0,
                               120.0, 300.0, 600.0, 900.0, 1800.0, 3600.0};
    const double least = seconds / std::max(count, 1.0);
    const auto* const found = std::ranges::lower_bound(steps, least);
    return found == steps.end() ? steps.back() : *found;
}
