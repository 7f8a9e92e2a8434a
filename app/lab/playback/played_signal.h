#pragma once

#include "lab/playback/audio_devices.h"
#include "lab/playback/beam_feed.h"
#include "lab/playback/live_input.h"
#include "model/look/sound_texture.h"
#include "model/look/spec.h"
#include "model/plan/beam.h"
#include "model/tuning/modulation.h"
#include "signals/audio/sample_stream.h"
#include "signals/signal/signal.h"

#include <filesystem>
#include <memory>

/// The sound, scene or drawing of a signal's file.
struct SignalFile {
    std::filesystem::path file;
    std::shared_ptr<const Sound> sound;           // shared with the audio thread
    std::shared_ptr<const BeamScene> scene = {};  // shared with the loader thread
    std::shared_ptr<const Drawing> drawing = {};  // also shared with it

    bool operator==(const SignalFile&) const = default;
};

/// The current signal and its input: a file, live sound or the beam of another program.
class PlayedSignal {
public:
    /// `sender_timeout` as in BeamInput::set_timeout().
    PlayedSignal(BeamInput::Pace pace, double sender_timeout)
        : m_pace(pace), m_sender_timeout(sender_timeout) {}

    /// Opens the live sound or the beam of another program that a completed spec needs.
    Result<void> open_input(const Spec& complete, const AudioDevices& devices, double time);
    /// Makes the signal of a completed spec whose input is open, and closes other inputs. An empty
    /// spec means no signal. On an error the previous signal stays.
    Result<void> set(Spec complete, SignalFile sound);
    /// Whether this is the current signal, and is neither live nor sent.
    bool is_current(const Spec& complete, const SignalFile& sound) const;
    /// The present of a live sound or of the sender gets this time.
    void seek(double time);

    const Spec& spec() const { return m_spec; }
    /// Null: no signal.
    const Signal* get() const { return m_signal.get(); }
    /// A copy with a state of its own; null: no signal.
    std::unique_ptr<Signal> copy() const;
    Beam trace(const TimeSpan& span) const;

    const SignalFile& sound() const { return m_sound; }
    /// The duration of the played part of the sound, in seconds; 0: no sound.
    double sound_seconds() const;
    SoundTrack track() const;
    /// The sound of a file's signal, as it plays; null: no such sound.
    std::shared_ptr<const SampleStream> sound_stream() const { return m_sound_stream; }
    /// The loudness of the sound, otherwise of the signal. Null: no signal, or a beam from another
    /// program. Shared with the renderer.
    std::shared_ptr<const Loudness> loudness() const { return m_loudness; }
    /// The sound textures, from the same source. For a signal without sound, x is the left channel
    /// and y the right one.
    std::shared_ptr<const SoundTexels> sound_texels() const { return m_sound_texels; }

    bool is_live() const;
    LiveInput& live_input() { return m_live_input; }
    const LiveInput& live_input() const { return m_live_input; }
    /// The beam from another program; null: not used.
    const BeamFeed* feed() const { return m_feed.get(); }

private:
    Result<void> open_feed(const Spec& complete, double time);
    Result<std::unique_ptr<Signal>> make(const Spec& complete, const SignalFile& sound) const;
    void measure();

    BeamInput::Pace m_pace;
    double m_sender_timeout;
    Spec m_spec;  // completed
    SignalFile m_sound;
    LiveInput m_live_input;
    std::unique_ptr<BeamFeed> m_feed;
    std::shared_ptr<const Signal> m_signal;  // shared with its loudness
    std::shared_ptr<const SampleStream> m_sound_stream;
    std::shared_ptr<const Loudness> m_loudness;
    std::shared_ptr<const SoundTexels> m_sound_texels;
};
