#include "lab/rendering/pace.h"

#include <algorithm>
#include <utility>

void Pace::add(double wall_seconds, bool was_busy) {
    if (wall_seconds <= 0.0 || (wall_seconds > 1.0 && !was_busy))
        return;
    m_milliseconds[m_next] = static_cast<float>(wall_seconds * 1000.0);
    m_next = (m_next + 1) % length;
    const double smoothing = std::min(wall_seconds / 0.5, 1.0);
    m_seconds =
        m_seconds == 0.0 ? wall_seconds : m_seconds + smoothing * (wall_seconds - m_seconds);
}

void Pace::expect(double wall_seconds, bool is_due) {
    constexpr double late = 1.1 / 30.0;  // the frames of a display are not exactly even
    constexpr double maximum = 0.5;      // a single long wait is not a slow picture
    if (!is_due || wall_seconds <= late) {
        m_slow_seconds = 0.0;
        return;
    }
    const double milliseconds = 1e3 * std::min(wall_seconds, maximum);
    constexpr double smoothing = 1.0 / 8.0;  // two seconds have few frames
    m_slow_milliseconds =
        m_slow_seconds == 0.0
            ? milliseconds
            : m_slow_milliseconds + smoothing * (milliseconds - m_slow_milliseconds);
    m_slow_seconds += std::min(wall_seconds, maximum);
}

void Pace::update(double wall_seconds, bool has_unfinished_frame, bool is_due) {
    const bool was_amid = m_frame_seconds > 0.0;
    m_frame_seconds += wall_seconds;
    if (has_unfinished_frame)
        return;
    const double seconds = std::exchange(m_frame_seconds, 0.0);
    add(seconds, was_amid);
    expect(seconds, is_due);
}
