#pragma once

#include "signals/audio/sample_stream.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

/// A sound up-sampled by `factor`. Sample k * factor is bit-identical to the sound's sample k. The
/// others are interpolated from 32 samples with a Kaiser-windowed sinc.
class Upsampler {
public:
    /// The factor is 1 .. 16.
    Upsampler(std::shared_ptr<const SampleStream> sound, int factor);

    const SampleStream& sound() const { return *m_sound; }
    int factor() const { return m_factor; }
    /// Up-sampled samples first, first + 1, ...; `first` may be any number.
    void read(std::int64_t first, std::span<StereoSample> samples) const;

private:
    static constexpr int taps = 32;
    static constexpr int before = taps / 2 - 1;  // taps before the sample
    static constexpr std::int64_t block = 128;   // original samples processed at once
    using Window = std::array<StereoSample, static_cast<std::size_t>(block) + taps>;
    using Phase = std::array<float, std::size_t{2} * taps>;  // each weight twice: left, right

    static Phase phase_of(double fraction);
    static StereoSample filtered(const StereoSample* window, const Phase& phase);

    std::shared_ptr<const SampleStream> m_sound;  // shared with other readers
    int m_factor;
    std::vector<Phase> m_phases;
};
