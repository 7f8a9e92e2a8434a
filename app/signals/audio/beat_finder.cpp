#include "signals/audio/beat_finder.h"

#include <cmath>

namespace {
constexpr double stretches_a_second = 100.0;
constexpr std::int64_t stretches_in_mean = 100;
constexpr std::int64_t stretches_at_rest = 20;
constexpr std::int64_t stretches_back = 200;
constexpr double bass_hertz = 150.0;
constexpr double silence = 1e-7;  // mean square, 70 dB below full scale

// The cached value of a stretch, computed if missing.
template <class Memory, class Make>
auto remembered(Memory& memory, std::int64_t stretch, const Make& make) {
    const auto count = static_cast<std::int64_t>(memory.size());
    auto& known = memory[static_cast<std::size_t>(((stretch % count) + count) % count)];
    if (known.stretch != stretch)
        known = {stretch, make()};
    return known.value;
}
}  // namespace

BeatFinder::BeatFinder(const SoundInput& input, double threshold)
    : m_rate(input.rate() / input.factor()),
      m_threshold(threshold),
      m_bass(m_rate, bass_hertz, [&input](std::int64_t first, std::span<StereoSample> samples) {
          input.read_originals(first, samples);
      }) {}

double BeatFinder::energy(std::int64_t stretch) const {
    return remembered(m_energies, stretch, [&] {
        const auto sample_at = [&](std::int64_t number) {
            const double seconds = static_cast<double>(number) / stretches_a_second;
            return static_cast<std::int64_t>(std::floor(seconds * m_rate + 1e-6));
        };
        const std::int64_t first = sample_at(stretch);
        m_samples.resize(static_cast<std::size_t>(sample_at(stretch + 1) - first));
        m_bass.read(first, m_samples);
        double sum = 0.0;
        for (const StereoSample& sample : m_samples)
            sum += static_cast<double>(sample.left) * sample.left;
        return m_samples.empty() ? 0.0 : sum / static_cast<double>(m_samples.size());
    });
}

bool BeatFinder::is_loud(std::int64_t stretch) const {
    return remembered(m_loud, stretch, [&] {
        double sum = 0.0;
        for (std::int64_t i = stretch - stretches_in_mean; i < stretch; ++i)
            sum += energy(i);
        const double now = energy(stretch);
        return now > silence && now > m_threshold * sum / stretches_in_mean;
    });
}

bool BeatFinder::is_beat(std::int64_t stretch) const {
    if (!is_loud(stretch))
        return false;
    for (std::int64_t i = stretch - stretches_at_rest; i < stretch; ++i)
        if (is_loud(i))
            return false;
    return true;
}

std::optional<double> BeatFinder::last_beat(double seconds) const {
    const auto now = static_cast<std::int64_t>(std::floor(seconds * stretches_a_second + 1e-6));
    for (std::int64_t stretch = now - 1; stretch >= now - stretches_back; --stretch)
        if (is_beat(stretch))
            return static_cast<double>(stretch + 1) / stretches_a_second;
    return std::nullopt;
}
