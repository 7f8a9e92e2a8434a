#pragma once

#include "model/tuning/modulation.h"
#include "signals/audio/beat_detector.h"
#include "signals/audio/envelope.h"
#include "signals/audio/sound_input.h"

/// The loudness of a sound and its beats.
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
    mutable std::map<double, BeatDetector> m_beats;  // by threshold
};

class Signal;

/// For signals other than sound: the distance of the beam from the centre. Has no beats.
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
