#pragma once

#include "model/tuning/modulation.h"
#include "signals/audio/beat_finder.h"
#include "signals/audio/envelope.h"
#include "signals/audio/sound_input.h"

/// How loud a sound is, and its beats.
class SoundLoudness : public Loudness {
public:
    explicit SoundLoudness(std::shared_ptr<const SampleStream> sound);

    double envelope(double seconds, double attack, double release) const override {
        return m_envelopes.at(seconds, attack, release);
    }
    std::optional<double> seconds_since_beat(double seconds, double threshold) const override;

private:
    std::shared_ptr<const SampleStream> m_sound;
    SoundInput m_input;
    Envelopes m_envelopes;
    mutable std::map<double, BeatFinder> m_beats;  // by threshold
};

class Signal;

/// How far a beam goes from the middle, for a signal that is no sound; it has no beats.
class BeamLoudness : public Loudness {
public:
    explicit BeamLoudness(std::shared_ptr<const Signal> signal);

    double envelope(double seconds, double attack, double release) const override {
        return m_envelopes.at(seconds, attack, release);
    }
    std::optional<double> seconds_since_beat(double /*seconds*/,
                                             double /*threshold*/) const override {
        return std::nullopt;
    }

private:
    Envelopes m_envelopes;
};
