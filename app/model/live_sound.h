#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

/// The last seconds of a stereo sound that is coming in. One thread writes and others read; nobody
/// waits.
class LiveSound {
public:
    explicit LiveSound(int rate);

    int rate() const { return m_rate; }
    /// Sample frames that have come in so far.
    std::int64_t frame_count() const { return m_count.load(std::memory_order_acquire); }
    double seconds() const { return static_cast<double>(frame_count()) / m_rate; }

    /// Interleaved; of one channel both sides are made, of more the first two are kept.
    void write(std::span<const float> samples, int channels) noexcept;
    /// Left and right in turn of the frames first, first + 1, ...; silence where they are forgotten
    /// or yet to come.
    void read(std::int64_t first, std::span<float> stereo) const;

private:
    static constexpr int seconds_kept = 16;

    int m_rate;
    std::vector<std::atomic<float>> m_samples;  // left and right in turn, by frame number
    std::atomic<std::int64_t> m_count = 0;
};
