#pragma once

#include "signals/audio/auto_gain.h"
#include "signals/audio/low_pass.h"
#include "signals/audio/upsampler.h"
#include "signals/scope/scope_knobs.h"

#include <array>
#include <optional>

/// What of a sound goes to a scope's two channels.
enum class SoundChannels { both, mean, left, right };

struct SoundPlug {
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

/// A sound as the two inputs of a scope, in volts behind gain and coupling.
class SoundInput {
public:
    SoundInput(std::shared_ptr<const SampleStream> sound, const SoundPlug& plug);
    SoundInput(const SoundInput&) = delete;
    SoundInput& operator=(const SoundInput&) = delete;

    int factor() const { return m_samples.factor(); }
    double rate() const { return m_rate; }  // up-sampled samples a second
    /// Up-sampled samples until the sound ends; endless when it loops or is live.
    std::int64_t count() const;
    double seconds() const;  // infinite when it never ends

    /// Up-sampled.
    void read(std::int64_t first, std::span<StereoSample> volts) const;
    /// At the sound's own samples.
    void read_originals(std::int64_t first, std::span<StereoSample> volts) const;

private:
    StereoSample plugged(StereoSample sample) const;
    void read_plugged(std::int64_t first, std::span<StereoSample> samples) const;
    float gain_at(double place) const;  // in samples of the sound
    void couple(StereoSample& sample, StereoSample slow) const;
    LowPass low_pass() const;

    SoundPlug m_plug;
    Upsampler m_samples;
    double m_rate;
    bool m_is_ac;
    std::optional<AutoGain> m_gain;
    LowPass m_slow;            // for read(); a state each, as both go on where they were
    LowPass m_slow_originals;  // for read_originals()
};

/// Reads an input ahead in blocks, up to `end`, for samples that are asked for mostly in order.
class SoundReader {
public:
    SoundReader(const SoundInput& input, std::int64_t end) : m_input(input), m_end(end) {}

    StereoSample at(std::int64_t sample);

private:
    const SoundInput& m_input;
    std::int64_t m_end;
    std::int64_t m_first = 0;
    std::int64_t m_filled = 0;  // the sample after the block
    std::array<StereoSample, 2048> m_block;
};
