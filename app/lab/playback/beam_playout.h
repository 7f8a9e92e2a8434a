#pragma once

#include "io/sound/sound_devices.h"
#include "signals/beam/beam_sampler.h"
#include "signals/signal/signal.h"

/// Plays the beam of a signal on an audio device in real time, for a real oscilloscope: x is left,
/// y is right.
class BeamPlayout {
public:
    explicit BeamPlayout(std::unique_ptr<BeamOutput> output) : m_output(std::move(output)) {}

    /// The signal must not be shared with the picture, because signals can have state. A signal
    /// that is known ahead plays in sync with its picture; others play 0.06 s later.
    void set_signal(std::unique_ptr<Signal> signal, bool is_known_ahead);
    /// The level of full deflection, 0 to 1 of full scale.
    void set_level(double level) { m_output->queue().set_level(level); }
    /// Plays up to the displayed time, at this speed.
    void follow(double time, double speed);
    /// Holds the beam; follow() can continue anywhere without a click.
    void rest();

    std::string device_name() const { return m_output->device_name(); }
    bool has_stalled() const { return m_output->has_stalled(); }

private:
    /// The buffered time at the device that avoids dropouts, s; and how far that is ahead of the
    /// picture.
    double cushion() const { return m_is_known_ahead ? 0.12 : 0.06; }
    double lead() const { return m_is_known_ahead ? cushion() : 0.0; }

    std::unique_ptr<BeamOutput> m_output;
    std::unique_ptr<Signal> m_signal;
    bool m_is_known_ahead = true;
    bool m_is_running = false;
    double m_played = 0.0;  // end time of the beam at the device
    BeamSampler m_sampler{0.02};
    Beam m_beam;
    std::vector<float> m_samples;
};
