#pragma once

#include "model/look/sound_texture.h"
#include "signals/audio/spectrum.h"

#include <memory>

/// Fills sound textures from a sound.
class SoundStreamTexels : public SoundTexels {
public:
    explicit SoundStreamTexels(std::shared_ptr<const SampleStream> sound);

    void read(const SoundTexture& texture, double seconds, std::span<float> levels) const override;

private:
    void read_wave(std::int64_t end, std::span<float> levels) const;
    void read_spectrum(const Spectrum& spectrum, std::int64_t hop, std::span<float> levels) const;
    void read_analyser(std::int64_t hop, std::int64_t end, std::span<float> levels) const;

    std::shared_ptr<const SampleStream> m_sound;
    SoundInput m_left_input;
    SoundInput m_right_input;
    SoundInput m_mean_input;
    Spectrum m_left;
    Spectrum m_right;
    Spectrum m_analyser;
    mutable std::vector<StereoSample> m_samples;
};
