#pragma once

#include "model/look/extent.h"

#include <span>
#include <string>

/// A texture of the sound up to a frame's end. It has two rows.
struct SoundTexture {
    // wave: the latest samples, oldest first, as 0.5 + 0.5 * sample; left, then right. With one
    // column: the largest absolute value of the latest 512 samples.
    // spectrum: the amplitude of frequencies from 0 Hz to half the sample rate; 1 is a full-scale
    // sine; left, then right.
    // analyser: as Web Audio's AnalyserNode, for the mean of both channels (2048 samples, smoothed
    // by 0.8, -100 to -30 dB as 0 to 1). The first row is the spectrum from 0 Hz, one bin per
    // column; the second is the wave.
    enum class Holds { wave, spectrum, analyser };

    Holds holds = Holds::wave;
    int columns = 512;

    bool operator==(const SoundTexture&) const = default;
    Extent extent() const { return {columns, 2}; }
    /// "sound wave 512".
    std::string name() const;
};

/// Computes sound textures: pure functions of the playback time.
class SoundTexels {
public:
    virtual ~SoundTexels() = default;
    /// One level per texel, row by row; `levels` has the texture's size.
    virtual void read(const SoundTexture& texture, double seconds,
                      std::span<float> levels) const = 0;
};

/// The levels for silence.
void read_silence(const SoundTexture& texture, std::span<float> levels);
