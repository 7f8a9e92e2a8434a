#include "signals/audio/auto_gain.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr int blocks_per_second = 10;
constexpr float min_peak = 0.01f;
constexpr double live_delay = 2.0;  // blocks, so that all blocks read are complete
}  // namespace

AutoGain::AutoGain(const SampleStream& sound)
    : m_sound(sound),
      m_block(std::max(sound.rate() / blocks_per_second, 1)),
      m_count((sound.length() + m_block - 1) / m_block) {}

float AutoGain::peak_of(std::int64_t block) const {
    Peak& known = m_peaks[static_cast<std::size_t>(block) % m_peaks.size()];
    if (known.block == block)
        return known.value;
    known = {block, min_peak};
    std::array<StereoSample, 256> samples;
    const std::int64_t end = std::min((block + 1) * m_block, m_sound.length());
    for (std::int64_t i = block * m_block; i < end;) {
        const auto count = std::min<std::int64_t>(end - i, samples.size());
        const std::span some = std::span(samples).first(static_cast<std::size_t>(count));
        m_sound.read(i, some);
        for (const StereoSample& sample : some)
            known.value = std::max({known.value, std::abs(sample.left), std::abs(sample.right)});
        i += count;
    }
    return known.value;
}

// The gain at the start of a block. Includes the peak of that block, so that nothing exceeds full
// scale while the gain is interpolated.
float AutoGain::gain_at(std::int64_t block) const {
    float peak = min_peak;
    for (std::int64_t i = block - blocks_per_second; i <= block; ++i) {
        const std::int64_t wrapped = ((i % m_count) + m_count) % m_count;
        if (m_sound.loops() || wrapped == i)
            peak = std::max(peak, peak_of(wrapped));
    }
    return 1.0f / peak;
}

float AutoGain::at(double position) const {
    const double delay = m_sound.is_live() ? live_delay : 0.0;
    const double blocks = std::max(position / static_cast<double>(m_block) - delay, 0.0);
    const auto below = std::min(static_cast<std::int64_t>(blocks), m_count - 1);
    const double between = std::min(blocks - static_cast<double>(below), 1.0);
    if (below != m_below)
        m_gains = {gain_at(below), gain_at(below + 1)};
    m_below = below;
    return std::lerp(m_gains[0], m_gains[1], static_cast<float>(between));
}
