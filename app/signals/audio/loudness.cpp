#include "signals/audio/loudness.h"

#include "signals/signal/signal.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
double sound_peak(const SampleStream& sound, std::int64_t stretch) {
    const auto sample_at = [&](std::int64_t number) {
        const double seconds = static_cast<double>(number) / Envelopes::blocks_per_second;
        return static_cast<std::int64_t>(std::floor(seconds * sound.rate() + 1e-6));
    };
    std::array<StereoSample, 512> block;
    float peak = 0.0f;
    const std::int64_t end = sample_at(stretch + 1);
    for (std::int64_t first = sample_at(stretch); first < end;) {
        const auto count = std::min<std::int64_t>(end - first, block.size());
        const std::span samples = std::span(block).first(static_cast<std::size_t>(count));
        sound.read(first, samples);
        for (const StereoSample& sample : samples)
            peak = std::max({peak, std::abs(sample.left), std::abs(sample.right)});
        first += count;
    }
    return peak;
}

double beam_peak(const Signal& signal, std::int64_t stretch) {
    Beam beam;
    signal.trace({static_cast<double>(stretch) / Envelopes::blocks_per_second,
                  static_cast<double>(stretch + 1) / Envelopes::blocks_per_second},
                 beam);
    float peak = 0.0f;
    for (const BeamPoint& point : beam)
        if (point.intensity > 0.0f)
            peak = std::max({peak, std::abs(point.x), std::abs(point.y)});
    return peak;
}
}  // namespace

SoundLoudness::SoundLoudness(std::shared_ptr<const SampleStream> sound)
    : m_sound(std::move(sound)),
      m_input(m_sound, {.channels = SoundChannels::mean, .upsample = 1}),
      m_envelopes([this](std::int64_t stretch) { return sound_peak(*m_sound, stretch); }) {}

std::optional<double> SoundLoudness::seconds_since_beat(double seconds, double threshold) const {
    constexpr std::size_t maximum = 8;  // limit while the user changes a threshold
    if (!m_beats.contains(threshold) && m_beats.size() >= maximum)
        m_beats.clear();
    const auto& [same, finder] = *m_beats.try_emplace(threshold, m_input, threshold).first;
    const auto beat = finder.last_beat(seconds);
    return beat ? std::optional(seconds - *beat) : std::nullopt;
}

BeamLoudness::BeamLoudness(std::shared_ptr<const Signal> signal)
    : m_envelopes([signal = std::move(signal)](std::int64_t stretch) {
          return beam_peak(*signal, stretch);
      }) {}
