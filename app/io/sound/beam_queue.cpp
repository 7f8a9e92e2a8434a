#include "io/sound/beam_queue.h"

#include <algorithm>

BeamQueue::BeamQueue(int rate)
    : m_rate(rate), m_samples(std::size_t{2} * static_cast<std::size_t>(rate)) {}

std::size_t BeamQueue::waiting() const {
    const std::int64_t begin = std::max(m_read.load(), m_start.load());
    return static_cast<std::size_t>(std::max<std::int64_t>(m_written - begin, 0));
}

void BeamQueue::write(std::span<const float> stereo) {
    const std::int64_t end = m_read.load(std::memory_order_acquire) + m_rate;
    std::int64_t frame = m_written;
    for (std::size_t i = 0; i + 1 < stereo.size() && frame < end; i += 2, ++frame) {
        const auto index = 2 * static_cast<std::size_t>(frame % m_rate);
        m_samples[index] = stereo[i];
        m_samples[index + 1] = stereo[i + 1];
    }
    m_written.store(frame, std::memory_order_release);
}

void BeamQueue::set_level(double level) {
    m_level.set(level >= 0.0 ? std::min(level, 1.0) : 0.0);
}

BeamQueue::Position BeamQueue::next() noexcept {
    const std::int64_t start = m_start;
    std::int64_t frame = m_read.load(std::memory_order_relaxed);
    if (frame < start) {
        frame = start;
        m_read.store(frame, std::memory_order_release);
        m_has_rested = true;
    }
    if (frame >= m_written.load(std::memory_order_acquire)) {
        m_has_rested = true;
        m_joining = 0;
        return m_last;
    }
    const auto index = 2 * static_cast<std::size_t>(frame % m_rate);
    const Position wanted{m_samples[index], m_samples[index + 1]};
    m_read.store(frame + 1, std::memory_order_release);
    const int all = m_rate / 200;
    if (m_has_rested) {
        m_away = {m_last.x - wanted.x, m_last.y - wanted.y};
        m_joining = all;
        m_has_rested = false;
    }
    const float share = all > 0 ? static_cast<float>(m_joining) / static_cast<float>(all) : 0.0f;
    m_joining = std::max(m_joining - 1, 0);
    m_last = {wanted.x + share * m_away.x, wanted.y + share * m_away.y};
    return m_last;
}

void BeamQueue::mix(std::span<float> stereo) noexcept {
    for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) {
        const Position at = next();
        stereo[i] = at.x;
        stereo[i + 1] = at.y;
    }
    m_level.apply(stereo);
}
