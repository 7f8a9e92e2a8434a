#include "signals/audio/mapped_sound.h"

#include <algorithm>
#include <cmath>

MappedSound::MappedSound(std::unique_ptr<Signal> signal, Streams streams, const ChannelMap& map,
                         int factor)
    : m_signal(std::move(signal)), m_streams(std::move(streams)), m_map(map), m_factor(factor) {}

namespace {
float light(float from, float to, float part) {
    return std::max(std::lerp(from, to, part), 0.0f);
}

/// The original samples around a range of up-sampled ones.
std::vector<StereoSample> samples_around(const SampleStream& stream, std::int64_t first,
                                         std::size_t count, int factor) {
    std::vector<StereoSample> samples(count / static_cast<std::size_t>(factor) + 3);
    stream.read(first / factor, samples);
    return samples;
}
}  // namespace

void MappedSound::trace(const TimeSpan& span, Beam& beam) const {
    const std::size_t begin = beam.size();
    m_signal->trace(span, beam);
    const std::size_t count = beam.size() - begin;
    const double rate = static_cast<double>(m_streams.current_and_red->rate()) * m_factor;
    const std::int64_t first = samples_in(span, rate).first;
    const auto reds = samples_around(*m_streams.current_and_red, first, count, m_factor);
    const auto blues = samples_around(*m_streams.green_and_blue, first, count, m_factor);
    if (m_map.has_tint())
        beam.tints.resize(beam.size());
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t sample = first + static_cast<std::int64_t>(i);
        const auto at = static_cast<std::size_t>(sample / m_factor - first / m_factor);
        const float part = static_cast<float>(sample % m_factor) / static_cast<float>(m_factor);
        if (m_map.intensity > 0)
            beam[begin + i].intensity *= light(reds[at].left, reds[at + 1].left, part);
        if (m_map.has_tint())
            beam.tints[begin + i] = {light(reds[at].right, reds[at + 1].right, part),
                                     light(blues[at].left, blues[at + 1].left, part),
                                     light(blues[at].right, blues[at + 1].right, part)};
    }
}
