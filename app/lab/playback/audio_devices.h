#pragma once

#include "io/sound/sound_devices.h"
#include "lab/playback/beam_playout.h"
#include "lab/playback/transport.h"

#include <memory>
#include <string>
#include <vector>

/// The played part of a sound.
struct SoundTrack {
    std::shared_ptr<const Sound> sound = {};  // shared with the audio thread; null: silence
    double start_seconds = 0.0;               // in the sound, at time 0
    bool loops = false;
    double end_seconds = 0.0;  // in the sound; 0: its end
};

/// The audio devices of the player: their settings, and the open output for the sound or for the
/// beam of the signal.
class AudioDevices {
public:
    /// `machine` is null if no devices are used.
    explicit AudioDevices(std::unique_ptr<SoundDevices> machine) : m_machine(std::move(machine)) {}

    bool has_devices() const { return m_machine != nullptr; }
    const SoundSettings& settings() const { return m_settings; }
    /// Closes the outputs and returns true if the settings need devices to be opened again.
    bool set_settings(const SoundSettings& settings);
    std::vector<SoundDevice> list() const;
    /// As in SoundDevices, with the settings. Only if has_devices().
    Result<std::unique_ptr<SoundCapture>> open_capture(int channels) const;

    /// Plays the beam of a signal instead of sound, if the settings say so; null: closes the
    /// device. An error changes the settings to sound.
    Result<void> play_beam(std::unique_ptr<Signal> signal, bool is_known_ahead);
    /// Plays a sound from the transport's time. A sound that already plays continues.
    Result<void> play_sound(const SoundTrack& track, const Transport& transport);
    /// Whether the beam is played, or not, as the settings say.
    bool is_beam_as_set() const { return m_settings.plays_beam == (m_playout != nullptr); }
    /// Applies the transport's speed, and plays or pauses.
    void follow(const Transport& transport);
    /// Plays the beam up to the transport's time.
    void advance_beam(const Transport& transport);
    void seek(double seconds);
    double level() const { return m_level; }
    void set_level(double level);  // 0 to 2, volume of the sound

    /// Whether a playing sound is the clock.
    bool is_clock() const;
    /// The time that the clock's sound has played since the last call or seek().
    double take_played_seconds();
    /// Whether an output cannot wait for slow frames: a playing sound or a real oscilloscope.
    bool plays_in_real_time() const { return is_clock() || m_playout; }
    /// The device that plays the beam; "": not played.
    std::string beam_device() const { return m_playout ? m_playout->device_name() : ""; }
    /// The error of an output that has stopped; "": none.
    std::string stall() const;

private:
    std::unique_ptr<SoundDevices> m_machine;
    SoundSettings m_settings;
    std::unique_ptr<SoundOutput> m_output;
    std::unique_ptr<BeamPlayout> m_playout;  // while the beam is played
    SoundTrack m_track;
    double m_level = 1.0;
    double m_heard = 0.0;  // s of the output at the last query
};
