#pragma once

#include "model/sound.h"
#include "signals/stereo_sample.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

/// Which part of a sound is read, and how it goes on at its ends.
struct SoundPart {
    std::int64_t first = 0;  // sample frame where it begins
    bool loops = false;      // else silence on both sides
};

/// A sound with `factor` times as many samples, through all of its own: sample k * factor is the
/// sound's sample k bit for bit, those between follow from 32 of them by a Kaiser-windowed sinc.
/// Mono is on both sides; of more than two channels the first two are read.
class Upsampler {
public:
    /// The sound has a rate, a channel and, from part.first on, a sample. The factor is 1 .. 16.
    Upsampler(std::shared_ptr<const Sound> sound, const SoundPart& part, int factor);

    int factor() const { return m_factor; }
    /// Of the part, in samples of the sound.
    std::int64_t length() const { return m_length; }
    /// The sound's own sample, counted from the part's begin; any number.
    StereoSample original(std::int64_t place) const;
    /// Up-sampled samples first, first + 1, ... of the part; first may be any number.
    void read(std::int64_t first, std::span<StereoSample> samples) const;

private:
    static constexpr int taps = 32;
    static constexpr int before = taps / 2 - 1;  // taps that reach back from the sample
    static constexpr std::int64_t block = 128;   // originals that are worked on at once
    using Window = std::array<StereoSample, static_cast<std::size_t>(block) + taps>;
    using Phase = std::array<float, std::size_t{2} * taps>;  // each weight twice: left, right

    static Phase phase_of(double fraction);
    void copy_originals(std::int64_t first, std::span<StereoSample> samples) const;
    static StereoSample filtered(const StereoSample* window, const Phase& phase);

    std::shared_ptr<const Sound> m_sound;  // shared with the signal's owner and the sound device
    SoundPart m_part;
    std::int64_t m_length;
    int m_factor;
    std::vector<Phase> m_phases;
};
