#include "model/devices/live_sound.h"

#include <algorithm>

LiveSound::LiveSound(int rate, int channels)
    : m_rate(rate),
      m_channels(channels),
      m_samples(static_cast<std::size_t>(seconds_kept) * static_cast<std::size_t>(rate) *
                static_cast<std::size_t>(channels)) {}

void LiveSound::write(std::span<const float> samples, int channels) noexcept {
    const auto step = static_cast<std::size_t>(channels);
    const auto channel_count = static_cast<std::size_t>(m_channels);
    const auto frames = static_cast<std::int64_t>(m_samples.size() / channel_count);
    std::int64_t frame = m_count.load(std::memory_order_relaxed);
    for (std::size_t i = 0; i + step <= samples.size(); i += step, ++frame) {
        const auto index = channel_count * static_cast<std::size_t>(frame % frames);
        for (std::size_t channel = 0; channel < channel_count; ++channel)
            m_samples[index + channel].store(samples[i + std::min(channel, step - 1)],
                                             std::memory_order_relaxed);
    }
    m_count.store(frame, std::memory_order_release);
}

void LiveSound::read(std::int64_t first, std::span<float> samples) const {
    const auto channel_count = static_cast<std::size_t>(m_channels);
    const auto frames = static_cast<std::int64_t>(m_samples.size() / channel_count);
    const std::int64_t end = frame_count();
    // The oldest second may be overwritten during the call.
    const std::int64_t begin = end - frames + m_rate;
    for (std::size_t i = 0; i + channel_count <= samples.size(); i += channel_count, ++first) {
        const bool is_there = first >= 0 && first >= begin && first < end;
        const auto index = is_there ? channel_count * static_cast<std::size_t>(first % frames) : 0;
        for (std::size_t channel = 0; channel < channel_count; ++channel)
            samples[i + channel] =
                is_there ? m_samples[index + channel].load(std::memory_order_relaxed) : 0.0f;
    }
}
