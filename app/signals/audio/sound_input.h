#pragma once

#include "signals/audio/auto_gain.h"
#include "signals/audio/low_pass.h"
#include "signals/audio/upsampler.h"
#include "signals/scope/scope_controls.h"

#include <array>
#include <optional>

/// Which channels of a sound go to the scope's two channels.
enum class SoundChannels { both, mean, left, right };

struct SoundInputSettings {
    SoundChannels channels = SoundChannels::both;
    bool is_swapped = false;
    std::array<Coupling, 2> coupling{};
    double level = 1.0;  // a factor
    bool has_auto_gain = false;
    int upsample = 4;

    bool shows_left() const { return channels != SoundChannels::right; }
    bool shows_right() const {
        return channels == SoundChannels::right || channels == SoundChannels::both;
    }
};

/// A sound as the two inputs of a scope, in volts after gain and coupling.
class SoundInput {
public:
    SoundInput(std::shared_ptr<const SampleStream> sound, const SoundInputSettings& plug);
    SoundInput(const SoundInput&) = delete;
    SoundInput& operator=(const SoundInput&) = delete;

    int factor() const { return m_samples.factor(); }
    double rate() const { return m_rate; }  // up-sampled samples per second
    /// Number of up-sampled samples; endless for looping or live sound.
    std::int64_t count() const;
    double seconds() const;  // infinite for endless sound

    /// Reads up-sampled samples.
    void read(std::int64_t first, std::span<StereoSample> volts) const;
    /// Reads at the sound's own sample rate.
    void read_originals(std::int64_t first, std::span<StereoSample> volts) const;

private:
    StereoSample routed(StereoSample sample) const;
    void read_routed(std::int64_t first, std::span<StereoSample> samples) const;
    float gain_at(double position) const;  // position in samples of the sound
    void couple(StereoSample& sample, StereoSample slow) const;
    LowPass low_pass() const;

    SoundInputSettings m_plug;
    Upsampler m_samples;
    double m_rate;
    bool m_is_ac;
    std::optional<AutoGain> m_gain;
    LowPass m_slow;            // for read(); separate, because both filters keep a position
    LowPass m_slow_originals;  // for read_originals()
};

/// Reads an input ahead in blocks, up to `end`, for mostly sequential access.
class SoundReader {
public:
    SoundReader(const SoundInput& input, std::int64_t end) : m_input(input), m_end(end) {}

    StereoSample at(std::int64_t sample);

private:
    const SoundInput& m_input;
    std::int64_t m_end;
    std::int64_t m_first = 0;
    std::int64_t m_filled = 0;  // one past the last sample of the block
    std::array<StereoSample, 2048> m_block;
};
