#include "signals/audio/low_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

LowPass::LowPass(double rate, double hertz, Read read)
    : m_read(std::move(read)),
      m_block(std::max<std::int64_t>(static_cast<std::int64_t>(rate / 10.0), 1)) {
    // Samples older than ten time constants contribute less than 5e-5.
    constexpr double memory = 10.0;
    const double samples = rate / (2.0 * std::numbers::pi * hertz);
    m_memory = static_cast<std::int64_t>(std::ceil(memory * samples));
    m_pull = static_cast<float>(1.0 - std::exp(-1.0 / samples));
}

void LowPass::follow(StereoSample sample) const {
    m_state.left += m_pull * (sample.left - m_state.left);
    m_state.right += m_pull * (sample.right - m_state.right);
}

// Computes the state before `sample`, from the start of its block and m_memory before that.
void LowPass::prime(std::int64_t sample) const {
    const std::int64_t block = sample - ((sample % m_block) + m_block) % m_block;
    m_state = {};
    std::array<StereoSample, 512> samples;
    for (std::int64_t i = block - m_memory; i < sample;) {
        const auto count = std::min<std::int64_t>(sample - i, samples.size());
        const std::span some = std::span(samples).first(static_cast<std::size_t>(count));
        m_read(i, some);
        for (const StereoSample& one : some)
            follow(one);
        i += count;
    }
}

void LowPass::read(std::int64_t first, std::span<StereoSample> slow) const {
    m_read(first, slow);
    for (StereoSample& sample : slow) {
        if (first != m_next || first % m_block == 0)
            prime(first);
        follow(sample);
        sample = m_state;
        m_next = ++first;
    }
}
