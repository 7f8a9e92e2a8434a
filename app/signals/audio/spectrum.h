#pragma once

#include "signals/audio/sound_input.h"

#include <vector>

enum class SpectrumWindow { hann, blackman };

/// How loud each frequency of a sound's left input is, 60 times a second. Amplitudes: a sine of
/// full scale in the middle of a bin is 1. Under Hann's window one between two bins is at most 1.43
/// dB lower.
class Spectrum {
public:
    /// Of an input, which must live on. `size`: samples a transform, even. Each amplitude follows
    /// its present value with the time constant `smoothing_seconds`.
    Spectrum(const SoundInput& input, int size, double smoothing_seconds,
             SpectrumWindow window = SpectrumWindow::hann);
    ~Spectrum();
    Spectrum(const Spectrum&) = delete;
    Spectrum& operator=(const Spectrum&) = delete;

    static constexpr double hops_a_second = 60.0;

    double hertz_per_bin() const { return m_hertz_per_bin; }
    /// Of the samples up to hop / 60 s; size / 2 + 1 bins from 0 Hz on.
    const std::vector<float>& amplitudes(std::int64_t hop) const;

private:
    struct Transform;
    void smooth(std::int64_t hop) const;

    const SoundInput& m_input;
    double m_rate;  // samples of the sound a second
    double m_hertz_per_bin;
    double m_kept;          // of the last hop's value
    std::int64_t m_memory;  // hops that are looked back after a jump in time
    double m_full_scale;    // a real wave has its other half at negative frequencies
    std::unique_ptr<Transform> m_transform;
    mutable std::int64_t m_hop = INT64_MIN;
    mutable std::vector<float> m_amplitudes;
};

/// The amplitude in decibels of full scale; never below -200.
double decibels(double amplitude);
