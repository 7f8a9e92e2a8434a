#include "model/live_sound.h"

LiveSound::LiveSound(int rate)
    : m_rate(rate), m_samples(std::size_t{2} * seconds_kept * static_cast<std::size_t>(rate)) {}

void LiveSound::write(std::span<const float> samples, int channels) noexcept {
    const auto step = static_cast<std::size_t>(channels);
    const auto frames = static_cast<std::int64_t>(m_samples.size() / 2);
    std::int64_t frame = m_count.load(std::memory_order_relaxed);
    for (std::size_t i = 0; i + step <= samples.size(); i += step, ++frame) {
        const auto place = 2 * static_cast<std::size_t>(frame % frames);
        m_samples[place].store(samples[i], std::memory_order_relaxed);
        m_samples[place + 1].store(samples[channels > 1 ? i + 1 : i], std::memory_order_relaxed);
    }
    m_count.store(frame, std::memory_order_release);
}

void LiveSound::read(std::int64_t first, std::span<float> stereo) const {
    const auto frames = static_cast<std::int64_t>(m_samples.size() / 2);
    const std::int64_t end = frame_count();
    // The oldest second may be written over meanwhile.
    const std::int64_t begin = end - frames + m_rate;
    for (std::size_t i = 0; i + 1 < stereo.size(); i += 2, ++first) {
        const bool is_there = first >= 0 && first >= begin && first < end;
        const auto place = is_there ? 2 * static_cast<std::size_t>(first % frames) : 0;
        stereo[i] = is_there ? m_samples[place].load(std::memory_order_relaxed) : 0.0f;
        stereo[i + 1] = is_there ? m_samples[place + 1].load(std::memory_order_relaxed) : 0.0f;
    }
}
