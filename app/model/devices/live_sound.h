#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

/// The last seconds of a sound that is coming in. One thread writes and others read; nobody waits.
class LiveSound {
public:
    explicit LiveSound(int rate, int channels = 2);

    int rate() const { return m_rate; }
    int channels() const { return m_channels; }
    /// Sample frames that have come in so far.
    std::int64_t frame_count() const { return m_count.load(std::memory_order_acquire); }
    double seconds() const { return static_cast<double>(frame_count()) / m_rate; }

    /// Interleaved; where more channels are kept than come in, the last one is in all the others.
    void write(std::span<const float> samples, int channels) noexcept;
    /// All channels in turn of the frames first, first + 1, ...; silence where they are forgotten
    /// or yet to come.
    void read(std::int64_t first, std::span<float> samples) const;

private:
    static constexpr int seconds_kept = 16;

    int m_rate;
    int m_channels;
    std::vector<std::atomic<float>> m_samples;  // all channels in turn, by frame number
    std::atomic<std::int64_t> m_count = 0;
};
