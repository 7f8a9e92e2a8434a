#include "lab/inspect/round_robin.h"

#include <algorithm>

namespace {
constexpr double pause_seconds = 0.2;
constexpr double max_share = 0.1;      // of the time
constexpr double rest_seconds = 0.15;  // unchanged for this time: static
}  // namespace

void RoundRobin::restart(std::size_t count) {
    *this = {};
    m_count = count;
    m_new = count;
}

std::optional<std::size_t> RoundRobin::due(std::uint64_t picture, double seconds) {
    if (m_picture != picture) {
        m_picture = picture;
        m_changed = seconds;
        m_pending = m_count;
    }
    if (m_pending == 0)
        return std::nullopt;
    const bool is_static = seconds - m_changed >= rest_seconds;
    if (m_new == 0 && !is_static && seconds < m_due)
        return std::nullopt;
    return m_next;
}

void RoundRobin::done(double seconds, double seconds_taken) {
    m_next = (m_next + 1) % std::max(m_count, std::size_t{1});
    m_new -= m_new > 0 ? 1 : 0;
    m_pending -= m_pending > 0 ? 1 : 0;
    m_due = seconds + std::max(pause_seconds, seconds_taken / max_share);
}
