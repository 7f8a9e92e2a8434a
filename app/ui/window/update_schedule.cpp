#include "ui/window/update_schedule.h"

#include "lab/lab.h"

#include <utility>

namespace {
using TimePoint = std::chrono::steady_clock::time_point;

double seconds_between(TimePoint start, TimePoint end) {
    return std::chrono::duration<double>(end - start).count();
}

// Drawing continues after an event: widgets react a frame or two later, tooltips after a delay.
constexpr auto awake = std::chrono::milliseconds(450);
}  // namespace

UpdateSchedule::UpdateSchedule(const Lab& lab, const gpu::WindowEvents& events,
                               const Toolkit& toolkit)
    : m_lab(lab), m_events(events), m_toolkit(toolkit) {
    stay_awake();
}

bool UpdateSchedule::wait(double frame_seconds, bool is_pending) {
    constexpr double rest_seconds = 1.0;
    const Clock::time_point start = Clock::now();
    if (m_lab.is_moving())
        m_awake_until = start + awake;  // measurements of the last frame follow later
    const auto longer = std::chrono::seconds(is_pending ? 10 : 0);
    if (!m_lab.is_moving() && !m_toolkit.is_behind() && !m_toolkit.awaits_tooltip() &&
        start > m_awake_until + longer) {
        gpu::WindowEvents::wait(rest_seconds);
        if (seconds_between(start, Clock::now()) >= rest_seconds)
            return false;
        m_awake_until = Clock::now() + awake;
        return true;
    }
    const double left = frame_seconds - seconds_between(m_updated, start);
    constexpr double slack = 0.001;
    if (left > slack && !m_lab.frames().has_unfinished_frame())
        gpu::WindowEvents::wait(left - slack);
    else
        gpu::WindowEvents::poll();
    return true;
}

void UpdateSchedule::stay_awake() {
    m_attended_until = m_awake_until = Clock::now() + awake;
}

double UpdateSchedule::begin_update() {
    const Clock::time_point now = Clock::now();
    return seconds_between(std::exchange(m_updated, now), now);
}

// Whether the first picture of all is still pending.
bool UpdateSchedule::awaits_picture() {
    m_has_had_picture = m_has_had_picture || (m_lab.renderer() && m_lab.renderer()->has_drawn());
    const bool is_coming = m_lab.loader().is_loading() || m_lab.frames().has_unfinished_frame();
    return is_coming && !m_has_had_picture;
}

bool UpdateSchedule::is_before_panels() {
    constexpr double max_seconds = 0.25;
    return m_frame_number == 0 && awaits_picture() &&
           seconds_between(m_drawn, m_updated) < max_seconds;
}

// While a slow look draws, the panels are drawn ten times a second.
bool UpdateSchedule::are_panels_due() {
    constexpr double now_and_then = 0.1;
    if (!m_lab.frames().has_unfinished_frame() && !awaits_picture())
        return true;
    if (m_frame_number == 0 || m_events.has_input() || m_toolkit.is_behind() ||
        seconds_between(m_drawn, m_updated) > now_and_then)
        return true;
    return !awaits_picture() && (m_updated < m_attended_until || m_lab.loader().is_loading());
}

void UpdateSchedule::begin_panels() {
    m_drawn = m_updated;
    ++m_frame_number;
}
