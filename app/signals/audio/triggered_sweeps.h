#pragma once

#include "signals/audio/sound_input.h"
#include "signals/scope/sweeps.h"

#include <vector>

/// Sweeps triggered by a sound, found on demand. The scope is re-armed every few seconds, so that
/// the sweeps at any time do not depend on the whole history. This cuts off the sweep in progress.
class TriggeredSweeps : public Sweeps {
public:
    /// Reads one channel (0 or 1) of an input that must outlive this object. `length` in up-sampled
    /// samples.
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
    double m_timeout;             // time without a trigger before `automatic` starts a sweep
    std::int64_t m_epoch_length;  // samples of the sound

    // State of the current epoch; instants as in Sweep.
    mutable std::int64_t m_epoch = -1;
    mutable std::int64_t m_next = 0;  // next sample of the sound to examine
    mutable float m_last = 0.0f;      // the last sample relative to the trigger level
    mutable double m_ready = 0.0;     // earliest start of the next sweep
    mutable double m_event = 0.0;     // the last trigger, whether or not it started a sweep
    mutable std::vector<double> m_starts;
};
