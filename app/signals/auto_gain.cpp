#include "signals/auto_gain.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr int blocks_a_second = 10;
constexpr float least_peak = 0.01f;
}  // namespace

AutoGain::AutoGain(const Upsampler& sound, const SoundPart& part, int rate)
    : m_block(std::max(rate / blocks_a_second, 1)), m_loops(part.loops) {
    for (std::int64_t start = 0; start < sound.length(); start += m_block) {
        float peak = least_peak;
        for (std::int64_t i = start; i < std::min(start + m_block, sound.length()); ++i) {
            const StereoSample sample = sound.original(i);
            peak = std::max({peak, std::abs(sample.left), std::abs(sample.right)});
        }
        m_peaks.push_back(peak);
    }
    for (std::size_t i = 0; i <= m_peaks.size(); ++i)
        m_gains.push_back(1.0f / peak_before(static_cast<std::int64_t>(i)));
}

// The block that begins here counts too: on the way from one gain to the next nothing may stick
// out.
float AutoGain::peak_before(std::int64_t block) const {
    const auto count = static_cast<std::int64_t>(m_peaks.size());
    float peak = least_peak;
    for (std::int64_t i = block - blocks_a_second; i <= block; ++i) {
        const std::int64_t wrapped = ((i % count) + count) % count;
        if (m_loops || wrapped == i)
            peak = std::max(peak, m_peaks[static_cast<std::size_t>(wrapped)]);
    }
    return peak;
}

float AutoGain::at(double place) const {
    const double blocks = std::max(place / static_cast<double>(m_block), 0.0);
    const std::size_t below = std::min(static_cast<std::size_t>(blocks), m_peaks.size() - 1);
    const double between = std::min(blocks - static_cast<double>(below), 1.0);
    return std::lerp(m_gains[below], m_gains[below + 1], static_cast<float>(between));
}
