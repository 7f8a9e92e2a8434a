#include "signals/beam/beam_stream.h"

#include "signals/beam/beam_sampler.h"

// A block is sampled with the adjacent spans, from which the beam comes and to which it goes.
const std::vector<float>& BeamStream::block(std::int64_t number) const {
    constexpr std::size_t maximum = 32;
    if (const auto known = m_blocks.find(number); known != m_blocks.end())
        return known->second;
    if (m_blocks.size() >= maximum)
        m_blocks.clear();
    constexpr double step = 1.0 / samples_per_second;
    const auto start_of = [](std::int64_t block) {
        return static_cast<double>(block) / blocks_per_second;
    };
    BeamSampler sampler;
    sampler.start_at(start_of(number - 1) - step);
    std::vector<float> samples;
    Beam beam;
    for (std::int64_t near = number - 1; near <= number + 1; ++near) {
        const TimeSpan span{start_of(near), start_of(near + 1)};
        beam.clear();
        m_signal->trace(span, beam);
        sampler.take(span, beam, {step, 2}, samples);
    }
    while (samples.size() < 4 * samples_per_block)
        sampler.rest({step, 2}, samples);
    const auto first = samples.begin() + 2 * samples_per_block;
    return m_blocks[number] = {first, first + 2 * samples_per_block};
}

void BeamStream::read(std::int64_t first, std::span<StereoSample> samples) const {
    for (StereoSample& sample : samples) {
        sample = {};
        if (first >= 0) {
            const std::vector<float>& levels = block(first / samples_per_block);
            const auto at = static_cast<std::size_t>(2 * (first % samples_per_block));
            sample = {levels[at], levels[at + 1]};
        }
        ++first;
    }
}
