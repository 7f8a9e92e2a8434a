#include "lab/pace.h"

void Pace::add(double wall_seconds) {
    if (wall_seconds <= 0.0 || wall_seconds > 1.0)
        return;
    m_milliseconds[m_next] = static_cast<float>(wall_seconds * 1000.0);
    m_next = (m_next + 1) % length;
    constexpr double smoothing = 1.0 / 30.0;
    m_seconds =
        m_seconds == 0.0 ? wall_seconds : m_seconds + smoothing * (wall_seconds - m_seconds);
}
