#pragma once

#include "io/sound/sound_devices.h"
#include "signals/beam/beam_sampler.h"
#include "signals/signal/signal.h"

/// Plays the beam of a signal on a sound device while time goes by, for a real scope: x is left, y
/// right.
class BeamPlayout {
public:
    explicit BeamPlayout(std::unique_ptr<BeamOutput> output) : m_output(std::move(output)) {}

    /// A signal of its own, as the one that is drawn may remember where it was. One that is known
    /// ahead does not wait for what comes in: it is played together with its picture, others 0.06 s
    /// later.
    void set_signal(std::unique_ptr<Signal> signal, bool is_known_ahead);
    /// Full deflection, 0 .. 1 of full scale.
    void set_level(double level) { m_output->queue().set_level(level); }
    /// The picture shows this time now, and goes on at this speed.
    void follow(double time, double speed);
    /// The beam stays where it is; follow() goes on anywhere, without a click.
    void rest();

    std::string device_name() const { return m_output->device_name(); }
    bool has_stalled() const { return m_output->has_stalled(); }

private:
    /// What waits at the device so that it never runs dry, s, and how far that is ahead of the
    /// picture.
    double cushion() const { return m_is_known_ahead ? 0.12 : 0.06; }
    double lead() const { return m_is_known_ahead ? cushion() : 0.0; }

    std::unique_ptr<BeamOutput> m_output;
    std::unique_ptr<Signal> m_signal;
    bool m_is_known_ahead = true;
    bool m_is_running = false;
    double m_played = 0.0;  // time up to which the device has the beam
    BeamSampler m_sampler{0.02};
    Beam m_beam;
    std::vector<float> m_samples;
};
