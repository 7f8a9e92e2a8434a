#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

/// The last 16 seconds of a live sound. One thread writes and others read, without waiting.
class LiveSound {
public:
    explicit LiveSound(int rate, int channels = 2);

    int rate() const { return m_rate; }
    int channels() const { return m_channels; }
    /// Sample frames received so far.
    std::int64_t frame_count() const { return m_count.load(std::memory_order_acquire); }
    double seconds() const { return static_cast<double>(frame_count()) / m_rate; }

    /// Interleaved samples; additional stored channels repeat the last channel.
    void write(std::span<const float> samples, int channels) noexcept;
    /// Interleaved samples of all channels, starting at frame `first`. Silence for frames that are
    /// overwritten or not yet received.
    void read(std::int64_t first, std::span<float> samples) const;

private:
    static constexpr int seconds_kept = 16;

    int m_rate;
    int m_channels;
    std::vector<std::atomic<float>> m_samples;  // interleaved, by frame number
    std::atomic<std::int64_t> m_count = 0;
};
