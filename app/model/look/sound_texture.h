#pragma once

#include "model/look/extent.h"

#include <span>
#include <string>

/// A texture that follows the sound: its texels as the sound was up to a frame's end. It has two
/// rows.
struct SoundTexture {
    // wave: the latest samples, oldest first, at 0.5 + 0.5 * sample; left, then right. One column
    //   is the largest of the latest 512 samples without its sign.
    // spectrum: how loud the frequencies are from 0 Hz to half the sound's rate, where a sine of
    //   full scale is 1; left, then right.
    // analyser: what Web Audio's AnalyserNode gives of the mean of both (2048 samples, smoothed by
    //   0.8, -100 to -30 dB as 0 to 1): the spectrum from 0 Hz on, a bin a column; then the wave.
    enum class Holds { wave, spectrum, analyser };

    Holds holds = Holds::wave;
    int columns = 512;

    bool operator==(const SoundTexture&) const = default;
    Extent extent() const { return {columns, 2}; }
    /// "sound wave 512".
    std::string name() const;
};

/// What sound textures hold: pure functions of the time of what is heard.
class SoundTexels {
public:
    virtual ~SoundTexels() = default;
    /// A level a texel, row after row; as many as the texture has.
    virtual void read(const SoundTexture& texture, double seconds,
                      std::span<float> levels) const = 0;
};

/// The same where nothing is heard.
void read_silence(const SoundTexture& texture, std::span<float> levels);
