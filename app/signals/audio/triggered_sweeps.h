#pragma once

#include "signals/audio/sound_input.h"
#include "signals/scope/sweeps.h"

#include <vector>

/// The sweeps that a sound triggers. They are found as they are asked for; to find them at any time
/// without all that was before, the scope is armed anew every few seconds, which cuts the sweep
/// that then goes on.
class TriggeredSweeps : public Sweeps {
public:
    /// Of one channel (0 or 1) of an input, which must live on. `length` in up-sampled samples.
    TriggeredSweeps(const SoundInput& input, const Trigger& trigger, std::size_t channel,
                    bool is_inverted, double length);

    std::optional<Sweep> latest(std::int64_t sample) const override;

private:
    void begin(std::int64_t epoch) const;
    void find_up_to(std::int64_t sample) const;
    void follow(float level) const;
    void begin_unasked(double now) const;
    void sweep_from(double instant) const;

    const SoundInput& m_input;
    Trigger m_trigger;
    std::size_t m_channel;
    float m_sign;
    double m_length;
    double m_busy;                // sweep and hold-off
    double m_patience;            // without a trigger, before `automatic` runs on
    std::int64_t m_epoch_length;  // samples of the sound

    // What was found in the present epoch; instants as in Sweep.
    mutable std::int64_t m_epoch = -1;
    mutable std::int64_t m_next = 0;  // sample of the sound that is looked at next
    mutable float m_last = 0.0f;      // above the trigger's level
    mutable double m_ready = 0.0;     // when the next sweep may begin
    mutable double m_event = 0.0;     // the last trigger, whether it began a sweep or not
    mutable std::vector<double> m_starts;
};
