#include "signals/beam/beam_input.h"

#include "signals/signal/points.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace {
constexpr double end_slack = 1e-9;  // s: tolerance for span ends computed in two ways
constexpr double max_ahead = 0.25;  // s: how far a sender may be ahead
constexpr double cushion = 0.03;  // s: delay added for a late sender, so that its next point is not
                                  // late
constexpr double kept_seconds = 2.0;  // s: history that is kept for replays
constexpr std::size_t max_legs = 1000000;
constexpr double finest_rate = 4096.0 * 60.0;
}  // namespace

void BeamInput::append(std::span<const BeamInputPoint> points) {
    std::unique_lock lock(m_mutex);
    for (const BeamInputPoint& point : points) {
        if (m_end >= m_now + max_ahead)
            m_changed.notify_all();
        m_changed.wait(lock, [&] { return m_is_closed || m_end < m_now + max_ahead; });
        if (m_is_closed)
            return;
        append_one(point);
    }
    forget_old();
    m_changed.notify_all();
}

void BeamInput::append_one(const BeamInputPoint& point) {
    const Position to{point.x, point.y};
    const Position from = m_has_last ? m_last : to;
    if (m_pace == Pace::live && m_end < m_now + end_slack) {
        const double start = m_now + cushion;
        m_legs.push_back({m_end, start - m_end, from, from, 0.0f});
        m_end = start;
    }
    m_legs.push_back(
        {m_end, point.seconds, from, to, point.current, point.tint.value_or(BeamTint())});
    m_has_tints = m_has_tints || point.tint;
    m_end += point.seconds;
    m_last = to;
    m_has_last = true;
}

void BeamInput::forget_old() {
    while (!m_legs.empty() && (m_legs.front().end() < m_now - kept_seconds ||
                               (m_legs.size() > max_legs && m_legs.front().end() < m_now)))
        m_legs.pop_front();
}

void BeamInput::end() {
    const std::lock_guard lock(m_mutex);
    m_has_ended = true;
    m_changed.notify_all();
}

void BeamInput::close() {
    const std::lock_guard lock(m_mutex);
    m_is_closed = true;
    m_changed.notify_all();
}

void BeamInput::start_at(double seconds) {
    const std::lock_guard lock(m_mutex);
    m_legs.clear();
    m_now = m_end = seconds;
    m_changed.notify_all();
}

// Each new point restarts the timeout.
void BeamInput::wait_for_points(std::unique_lock<std::mutex>& lock, double until) {
    const auto is_done = [&] { return m_is_closed || m_has_ended || m_end > until + end_slack; };
    if (std::isinf(m_timeout_seconds)) {
        m_changed.wait(lock, is_done);
        return;
    }
    const std::chrono::duration<double> timeout(m_timeout_seconds);
    while (!is_done()) {
        const double before = m_end;
        if (m_changed.wait_for(lock, timeout, [&] { return is_done() || m_end > before; }))
            continue;
        m_has_timed_out = m_has_ended = true;
    }
}

void BeamInput::trace(const TimeSpan& span, Beam& beam) {
    std::unique_lock lock(m_mutex);
    m_now = std::max(m_now, span.end);
    m_changed.notify_all();
    if (m_pace == Pace::waiting)
        wait_for_points(lock, span.end);
    if (m_has_tints)
        beam.tints.resize(beam.size());
    auto leg = std::upper_bound(
        m_legs.begin(), m_legs.end(), span.start,
        [](double time, const Leg& other) { return time < other.end() + end_slack; });
    for (; leg != m_legs.end() && leg->begin <= span.end; ++leg)
        trace_leg(*leg, span, beam);
}

// A lit segment is subdivided finely to distribute its light evenly.
void BeamInput::trace_leg(const Leg& leg, const TimeSpan& span, Beam& beam) const {
    const bool is_lit = leg.current > 0.0f;
    const double steps = is_lit ? std::max(1.0, std::ceil(leg.seconds * finest_rate - 1e-6)) : 1.0;
    const double step = leg.seconds / steps;
    const double charge =
        is_lit ? static_cast<double>(leg.current) * step * charge_of_point(1.0) : 0.0;
    const double first = std::floor((span.start - leg.begin) / step);
    for (double i = std::clamp(first, 1.0, steps); i <= steps; ++i) {
        const double time = leg.begin + i * step;
        if (time > span.end + end_slack)
            return;
        if (time <= span.start + end_slack)
            continue;
        const auto share = static_cast<float>(i / steps);
        beam.push_back({std::lerp(leg.from.x, leg.to.x, share),
                        std::lerp(leg.from.y, leg.to.y, share), static_cast<float>(charge),
                        static_cast<float>(std::max(span.end - time, 0.0))});
        if (m_has_tints)
            beam.tints.push_back(leg.tint);
    }
}
