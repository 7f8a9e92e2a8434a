#include "signals/audio/beat_detector.h"

#include <cmath>

namespace {
constexpr double beat_blocks_per_second = 100.0;
constexpr std::int64_t blocks_in_mean = 100;
constexpr std::int64_t blocks_at_rest = 20;
constexpr std::int64_t blocks_back = 200;
constexpr double bass_hertz = 150.0;
constexpr double silence = 1e-7;  // mean square, 70 dB below full scale

// The cached value of a block, computed if missing.
template <class Memory, class Make>
auto cached(Memory& memory, std::int64_t block, const Make& make) {
    const auto count = static_cast<std::int64_t>(memory.size());
    auto& known = memory[static_cast<std::size_t>(((block % count) + count) % count)];
    if (known.block != block)
        known = {block, make()};
    return known.value;
}
}  // namespace

BeatDetector::BeatDetector(const SoundInput& input, double threshold)
    : m_rate(input.rate() / input.factor()),
      m_threshold(threshold),
      m_bass(m_rate, bass_hertz, [&input](std::int64_t first, std::span<StereoSample> samples) {
          input.read_originals(first, samples);
      }) {}

double BeatDetector::energy(std::int64_t block) const {
    return cached(m_energies, block, [&] {
        const auto sample_at = [&](std::int64_t number) {
            const double seconds = static_cast<double>(number) / beat_blocks_per_second;
            return static_cast<std::int64_t>(std::floor(seconds * m_rate + 1e-6));
        };
        const std::int64_t first = sample_at(block);
        m_samples.resize(static_cast<std::size_t>(sample_at(block + 1) - first));
        m_bass.read(first, m_samples);
        double sum = 0.0;
        for (const StereoSample& sample : m_samples)
            sum += static_cast<double>(sample.left) * sample.left;
        return m_samples.empty() ? 0.0 : sum / static_cast<double>(m_samples.size());
    });
}

bool BeatDetector::is_loud(std::int64_t block) const {
    return cached(m_loud, block, [&] {
        double sum = 0.0;
        for (std::int64_t i = block - blocks_in_mean; i < block; ++i)
            sum += energy(i);
        const double now = energy(block);
        return now > silence && now > m_threshold * sum / blocks_in_mean;
    });
}

bool BeatDetector::is_beat(std::int64_t block) const {
    if (!is_loud(block))
        return false;
    for (std::int64_t i = block - blocks_at_rest; i < block; ++i)
        if (is_loud(i))
            return false;
    return true;
}

std::optional<double> BeatDetector::last_beat(double seconds) const {
    const auto now = static_cast<std::int64_t>(std::floor(seconds * beat_blocks_per_second + 1e-6));
    for (std::int64_t block = now - 1; block >= now - blocks_back; --block)
        if (is_beat(block))
            return static_cast<double>(block + 1) / beat_blocks_per_second;
    return std::nullopt;
}
