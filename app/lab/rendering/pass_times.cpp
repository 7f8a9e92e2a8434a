#include "lab/rendering/pass_times.h"

#include <algorithm>
#include <numeric>

void PassTimes::add(const std::vector<double>& milliseconds) {
    if (passes() != milliseconds.size())
        *this = {};
    if (m_frames.size() < length) {
        m_frames.push_back(milliseconds);
        return;
    }
    m_frames[m_oldest] = milliseconds;
    m_oldest = (m_oldest + 1) % length;
}

double PassTimes::milliseconds(std::size_t pass, std::size_t frame) const {
    return m_frames[(m_oldest + frame) % m_frames.size()][pass];
}

double PassTimes::total(std::size_t frame) const {
    const std::vector<double>& times = m_frames[(m_oldest + frame) % m_frames.size()];
    return std::accumulate(times.begin(), times.end(), 0.0);
}

double PassTimes::current_total() const {
    constexpr std::size_t maximum = 20;
    const std::size_t count = std::min(frames(), maximum);
    double sum = 0.0;
    for (std::size_t i = frames() - count; i < frames(); ++i)
        sum += total(i);
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

double PassTimes::longest_total() const {
    double longest = 0.0;
    for (std::size_t i = 0; i < frames(); ++i)
        longest = std::max(longest, total(i));
    return longest;
}
