#include "lab/rendering/display_pace.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr double window_seconds = 1.0;
constexpr double least_seconds = 0.5;  // until a measurement counts
constexpr double least_source_rate = 50.0;
}  // namespace

void DisplayPace::clear() {
    *this = DisplayPace();
}

void DisplayPace::remove_old() {
    while (m_seconds - m_updates.front().seconds >= window_seconds) {
        const Update& oldest = m_updates.front();
        m_seconds -= oldest.seconds;
        m_refreshes -= oldest.refreshes;
        m_even_seconds -= oldest.is_even ? oldest.seconds : 0.0;
        m_even_count -= oldest.is_even ? 1 : 0;
        m_updates.pop_front();
    }
}

void DisplayPace::add(double wall_seconds, double refresh_rate, bool is_moving) {
    if (refresh_rate != m_reported || !is_moving || wall_seconds > window_seconds)
        clear();
    m_reported = refresh_rate;
    if (!is_moving || wall_seconds <= 0.0 || wall_seconds > window_seconds || refresh_rate <= 0.0)
        return;
    // The times of single updates jitter, so their refreshes are counted from the sum of times.
    constexpr double jitter = 0.25;
    m_phase += wall_seconds * this->refresh_rate();
    const int refreshes = std::max(0, static_cast<int>(std::lround(m_phase)));
    m_phase -= refreshes;
    const bool is_even = std::abs(wall_seconds * refresh_rate - 1.0) < jitter;
    m_updates.push_back({wall_seconds, refreshes, is_even});
    m_seconds += wall_seconds;
    m_refreshes += refreshes;
    m_even_seconds += is_even ? wall_seconds : 0.0;
    m_even_count += is_even ? 1 : 0;
    remove_old();
    const int possible = possible_subframes();
    m_better_seconds = possible > m_most_subframes ? m_better_seconds + wall_seconds : 0.0;
    if (possible < m_most_subframes || m_better_seconds >= window_seconds) {
        m_most_subframes = possible;
        m_better_seconds = 0.0;
    }
}

double DisplayPace::refresh_rate() const {
    constexpr int least_count = 10;
    return m_even_count < least_count ? m_reported : m_even_count / m_even_seconds;
}

double DisplayPace::pictures_per_second() const {
    return m_seconds < least_seconds ? 0.0 : static_cast<double>(m_updates.size()) / m_seconds;
}

int DisplayPace::drops() const {
    return std::max(0, m_refreshes - static_cast<int>(m_updates.size()));
}

int DisplayPace::possible_subframes() const {
    constexpr double tolerance = 1.01;  // of the clocks, and a drop now and then
    // A window that does not wait for the display would be faster than it.
    const double rate =
        std::min({refresh_rate(), tolerance * m_reported, tolerance * pictures_per_second()});
    return std::max(1, static_cast<int>(std::floor(tolerance * rate / least_source_rate)));
}
