#include "io/sound/device_watch.h"

#include <algorithm>

bool DeviceWatch::served(double seconds, Clock::time_point now) noexcept {
    constexpr double max_ahead = 5.0;  // s; sound servers request two at once
    constexpr double fastest = 1.5;    // no device's clock is this fast
    const double passed = std::chrono::duration<double>(now - m_served.load()).count();
    m_ahead = std::max(0.0, m_ahead - fastest * passed) + seconds;
    m_served = now;
    m_has_begun = true;
    if (m_ahead > max_ahead)
        m_has_run_away = true;
    return !m_has_run_away;
}

bool DeviceWatch::is_lost(Clock::time_point now) const {
    const std::chrono::seconds timeout(m_has_begun ? 1 : 4);
    return m_has_run_away || now - m_served.load() > timeout;
}
