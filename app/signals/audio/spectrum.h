#pragma once

#include "signals/audio/sound_input.h"

#include <vector>

enum class SpectrumWindow { hann, blackman };

/// Amplitude spectrum of a sound's left input at 60 Hz. A full-scale sine at the centre of a bin
/// has amplitude 1. With the Hann window a sine between two bins is at most 1.43 dB lower.
class Spectrum {
public:
    /// The input must outlive this object. `size`: samples per transform, even. Each amplitude is
    /// smoothed with the time constant `smoothing_seconds`.
    Spectrum(const SoundInput& input, int size, double smoothing_seconds,
             SpectrumWindow window = SpectrumWindow::hann);
    ~Spectrum();
    Spectrum(const Spectrum&) = delete;
    Spectrum& operator=(const Spectrum&) = delete;

    static constexpr double hops_per_second = 60.0;

    double hertz_per_bin() const { return m_hertz_per_bin; }
    /// From the samples up to hop / 60 s: size / 2 + 1 bins, starting at 0 Hz.
    const std::vector<float>& amplitudes(std::int64_t hop) const;

private:
    struct Transform;
    void smooth(std::int64_t hop) const;

    const SoundInput& m_input;
    double m_rate;  // of the sound, samples per second
    double m_hertz_per_bin;
    double m_kept;          // weight of the last hop's value
    std::int64_t m_memory;  // hops to read after a jump in time
    double m_full_scale;    // a real signal has half its energy at negative frequencies
    std::unique_ptr<Transform> m_transform;
    mutable std::int64_t m_hop = INT64_MIN;
    mutable std::vector<float> m_amplitudes;
};

/// The amplitude in decibels relative to full scale, at least -200.
double decibels(double amplitude);
