#include "signals/audio/sound_texels.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr int transform_size = 2048;     // samples
constexpr std::size_t level_size = 512;  // samples; each column is their largest
// Web Audio API, AnalyserNode: the smoothingTimeConstant, the ends of its decibel range, and the
// magnitude of a full-scale sine. Its transform divides by the size and does not correct for the
// Blackman window, whose mean is 0.42.
constexpr double analyser_keeps = 0.8;
constexpr double analyser_floor = -100.0;
constexpr double analyser_ceiling = -30.0;
constexpr double analyser_full_scale = 0.5 * 0.42;

SoundInputSettings plug_of(SoundChannels channels) {
    return {.channels = channels, .upsample = 1};
}

double analyser_smoothing_seconds() {
    return -1.0 / (Spectrum::hops_per_second * std::log(analyser_keeps));
}

float wave_level(float sample) {
    return 0.5f + 0.5f * sample;
}

float largest(std::span<const StereoSample> samples, float StereoSample::*side) {
    float maximum = 0.0f;
    for (const StereoSample& sample : samples)
        maximum = std::max(maximum, std::abs(sample.*side));
    return maximum;
}

float analyser_level(float amplitude) {
    const double above = decibels(analyser_full_scale * amplitude) - analyser_floor;
    return static_cast<float>(std::clamp(above / (analyser_ceiling - analyser_floor), 0.0, 1.0));
}
}  // namespace

SoundStreamTexels::SoundStreamTexels(std::shared_ptr<const SampleStream> sound)
    : m_sound(std::move(sound)),
      m_left_input(m_sound, plug_of(SoundChannels::left)),
      m_right_input(m_sound, {.is_swapped = true, .upsample = 1}),
      m_mean_input(m_sound, plug_of(SoundChannels::mean)),
      m_left(m_left_input, transform_size, 0.0),
      m_right(m_right_input, transform_size, 0.0),
      m_analyser(m_mean_input, transform_size, analyser_smoothing_seconds(),
                 SpectrumWindow::blackman) {}

void SoundStreamTexels::read_wave(std::int64_t end, std::span<float> levels) const {
    const std::size_t columns = levels.size() / 2;
    m_samples.resize(columns == 1 ? level_size : columns);
    m_sound->read(end - static_cast<std::int64_t>(m_samples.size()), m_samples);
    if (columns == 1) {
        levels[0] = wave_level(largest(m_samples, &StereoSample::left));
        levels[1] = wave_level(largest(m_samples, &StereoSample::right));
        return;
    }
    for (std::size_t i = 0; i < columns; ++i) {
        levels[i] = wave_level(m_samples[i].left);
        levels[columns + i] = wave_level(m_samples[i].right);
    }
}

// Each column is the loudest of its bins. With fewer bins than columns, bins repeat.
void SoundStreamTexels::read_spectrum(const Spectrum& spectrum, std::int64_t hop,
                                      std::span<float> levels) const {
    constexpr std::size_t bins = transform_size / 2;
    const std::vector<float>& amplitudes = spectrum.amplitudes(hop);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const std::size_t first = i * bins / levels.size();
        const std::size_t end = std::max((i + 1) * bins / levels.size(), first + 1);
        levels[i] = *std::max_element(amplitudes.begin() + static_cast<std::ptrdiff_t>(first),
                                      amplitudes.begin() + static_cast<std::ptrdiff_t>(end));
    }
}

void SoundStreamTexels::read_analyser(std::int64_t hop, std::int64_t end,
                                      std::span<float> levels) const {
    const std::vector<float>& amplitudes = m_analyser.amplitudes(hop);
    const std::size_t columns = levels.size() / 2;
    m_samples.resize(std::max<std::size_t>(columns, transform_size));
    m_sound->read(end - static_cast<std::int64_t>(m_samples.size()), m_samples);
    for (std::size_t i = 0; i < columns; ++i) {
        levels[i] = analyser_level(i < amplitudes.size() ? amplitudes[i] : 0.0f);
        levels[columns + i] = wave_level(0.5f * (m_samples[i].left + m_samples[i].right));
    }
}

void SoundStreamTexels::read(const SoundTexture& texture, double seconds,
                             std::span<float> levels) const {
    const auto end = static_cast<std::int64_t>(std::floor(seconds * m_sound->rate() + 1e-6));
    const auto hop =
        static_cast<std::int64_t>(std::floor(seconds * Spectrum::hops_per_second + 1e-6));
    const std::size_t row = levels.size() / 2;
    switch (texture.holds) {
        case SoundTexture::Holds::wave:
            return read_wave(end, levels);
        case SoundTexture::Holds::spectrum:
            read_spectrum(m_left, hop, levels.first(row));
            return read_spectrum(m_right, hop, levels.subspan(row));
        case SoundTexture::Holds::analyser:
            return read_analyser(hop, end, levels);
    }
}
