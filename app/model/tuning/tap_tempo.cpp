#include "model/tuning/tap_tempo.h"

#include "model/tuning/tempo.h"

#include <algorithm>
#include <vector>

std::optional<double> TapTempo::tap(double seconds) {
    constexpr double pause = 2.0;  // s
    constexpr std::size_t max_intervals = 8;
    if (!m_taps.empty() && (seconds - m_taps.back() > pause || seconds < m_taps.back()))
        m_taps.clear();
    m_taps.push_back(seconds);
    if (m_taps.size() > max_intervals + 1)
        m_taps.pop_front();
    std::vector<double> intervals;
    for (std::size_t i = 1; i < m_taps.size(); ++i)
        intervals.push_back(m_taps[i] - m_taps[i - 1]);
    if (intervals.empty())
        return std::nullopt;
    std::ranges::sort(intervals);
    const std::size_t half = intervals.size() / 2;
    const double median =
        intervals.size() % 2 == 1 ? intervals[half] : 0.5 * (intervals[half - 1] + intervals[half]);
    const double bpm = median > 0.0 ? 60.0 / median : 0.0;
    return bpm >= min_bpm && bpm <= max_bpm ? std::optional(bpm) : std::nullopt;
}
