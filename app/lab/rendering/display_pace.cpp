#include "lab/rendering/display_pace.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr double window_seconds = 1.0;
constexpr double least_seconds = 0.5;  // until a measurement counts
constexpr double least_source_rate = 50.0;
}  // namespace

void DisplayPace::clear() {
    m_updates.clear();
    m_seconds = 0.0;
    m_refreshes = 0;
}

void DisplayPace::add(double wall_seconds, double refresh_rate, bool is_moving) {
    if (refresh_rate != m_reported || !is_moving || wall_seconds > window_seconds)
        clear();
    m_reported = refresh_rate;
    if (!is_moving || wall_seconds <= 0.0 || wall_seconds > window_seconds || refresh_rate <= 0.0)
        return;
    const int refreshes = std::max(1, static_cast<int>(std::lround(wall_seconds * refresh_rate)));
    m_updates.push_back({wall_seconds, refreshes});
    m_seconds += wall_seconds;
    m_refreshes += refreshes;
    while (m_seconds - m_updates.front().seconds >= window_seconds) {
        m_seconds -= m_updates.front().seconds;
        m_refreshes -= m_updates.front().refreshes;
        m_updates.pop_front();
    }
}

double DisplayPace::refresh_rate() const {
    return m_seconds < least_seconds ? m_reported : m_refreshes / m_seconds;
}

double DisplayPace::pictures_per_second() const {
    return m_seconds < least_seconds ? 0.0 : static_cast<double>(m_updates.size()) / m_seconds;
}

int DisplayPace::drops() const {
    return m_refreshes - static_cast<int>(m_updates.size());
}

int DisplayPace::most_subframes() const {
    constexpr double tolerance = 1.01;  // of the clocks, and a drop now and then
    const double rate = std::min(refresh_rate(), tolerance * pictures_per_second());
    return std::max(1, static_cast<int>(std::floor(tolerance * rate / least_source_rate)));
}
