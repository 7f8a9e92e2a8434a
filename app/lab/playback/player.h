#pragma once

#include "base/diagnostic.h"
#include "io/sound/sound_devices.h"
#include "lab/playback/beam_feed.h"
#include "lab/playback/beam_playout.h"
#include "model/look/sound_texture.h"
#include "model/look/spec.h"
#include "model/plan/beam.h"
#include "model/tuning/modulation.h"
#include "signals/audio/sample_stream.h"
#include "signals/signal/clock.h"
#include "signals/signal/signal.h"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>

/// A frame on the player's clock.
struct PlayedFrame {
    std::int64_t number = 0;  // from 1 after a restart
    TimeSpan span;
};

/// The sound, scene or drawing of a signal's file.
struct PlayedSound {
    std::filesystem::path file;
    std::shared_ptr<const Sound> sound;           // shared with the audio thread
    std::shared_ptr<const BeamScene> scene = {};  // shared with the loader thread
    std::shared_ptr<const Drawing> drawing = {};  // also shared with it
};

/// The clock and the current signal.
class Player {
public:
    /// `devices` are for the window; null: no audio devices are used.
    explicit Player(std::unique_ptr<SoundDevices> devices = nullptr)
        : m_devices(std::move(devices)) {}

    /// Sets the signal of a spec, with `sound` if its kind plays one. A spec without a kind means
    /// no signal. On an error the previous signal stays.
    Result<void> set_signal(const Spec& spec, PlayedSound sound = {});
    const Signal* signal() const { return m_signal.get(); }
    const PlayedSound& sound() const { return m_sound; }
    /// The duration of the played part of the sound, in seconds; 0: no sound.
    double sound_seconds() const;
    /// The error of sound output, live input or the beam of another program; "": no error.
    std::string silence() const;
    /// The device of the live input; "": not open.
    std::string live_device() const { return m_capture ? m_capture->device_name() : ""; }

    /// Closes or opens the device of the live input.
    Result<void> mute_input(bool is_muted);
    /// Whether the signal is a live input that is muted.
    bool draws_muted_input() const;

    /// The errors in the beam of another program.
    Diagnostics beam_input_problems() const { return m_feed ? m_feed->problems() : Diagnostics(); }
    /// As BeamFeed::state(); "": not used.
    std::string sender_state() const { return m_feed ? m_feed->state() : std::string(); }
    /// As BeamInput::set_patience(), for later senders.
    void set_sender_patience(double seconds) { m_sender_patience = seconds; }

    /// The device that plays the beam; "": not played.
    std::string beam_device() const { return m_playout ? m_playout->device_name() : ""; }

    const SoundSettings& sound_settings() const { return m_settings; }
    /// Reopens the devices in use.
    Result<void> set_sound_settings(const SoundSettings& settings);
    std::vector<SoundDevice> sound_devices() const;

    bool is_playing() const { return m_is_playing; }
    double speed() const { return m_speed; }
    double time() const { return m_time; }
    std::int64_t frame_number() const { return m_frame; }
    double level() const { return m_level; }

    void play();
    void pause();
    void restart();
    void seek(double seconds);
    /// As seek(), with a past of up to this number of frames, so that they can be replayed.
    void seek_with_past(double seconds, std::size_t frames);
    void set_speed(double speed);  // 0.01 to 4
    void set_level(double level);  // 0 to 2, volume of the sound
    /// The next advance() covers one frame of 1/60 s, even while paused.
    void step() { m_is_stepping = true; }
    /// Seeks to the end of a past frame, if it is still stored.
    void go_back_to(std::int64_t frame);

    /// The frame for `wall_seconds` since the last call; nullopt: paused, or the signal has ended.
    /// While a sound plays or live input is drawn, its device is the clock.
    std::optional<PlayedFrame> advance(double wall_seconds);
    /// The next frame of a fixed frame rate, for offline drawing.
    PlayedFrame advance_fixed(double fps);

    /// The longest time that one frame can cover, 1/240 to 1/4 s. On a slower machine, playback is
    /// slower, or part of a playing sound is not drawn.
    void set_longest_frame(double seconds);
    /// The share of elapsed time that is drawn, over about the last 0.5 s or the last frame if it
    /// was longer. 1: in real time. A single delayed frame does not count.
    double shown_share() const { return m_shown_share; }
    /// Whether undrawn time is skipped, because a playing sound or a real oscilloscope cannot wait.
    bool leaves_out() const { return is_sound_the_clock() || m_playout; }

    Beam trace(const TimeSpan& span) const;
    /// The sound of a file's signal, as it plays; null: no such sound.
    std::shared_ptr<const SampleStream> heard() const { return m_heard_stream; }
    /// The loudness of the sound, otherwise of the signal. Null: no signal, or a beam from another
    /// program. Shared with the renderer.
    std::shared_ptr<const Loudness> loudness() const { return m_loudness; }
    /// The sound textures, from the same source. For a signal without sound, x is the left channel
    /// and y the right one.
    std::shared_ptr<const SoundTexels> sound_texels() const { return m_sound_texels; }

    /// The latest frames, oldest first, for replays.
    const std::deque<PlayedFrame>& past() const { return m_past; }

private:
    Result<std::unique_ptr<Signal>> make(const Spec& complete, const PlayedSound& sound);
    Result<void> open_capture(const Spec& complete);
    Result<void> open_feed(const Spec& complete);
    void play_beam();
    void begin_live();
    void listen();
    void play_sound(bool loops, bool is_new_sound);
    bool is_sound_the_clock() const;
    void notice_lost_devices();
    std::optional<PlayedFrame> advance_picture(double wall_seconds);
    std::optional<PlayedFrame> advance_live(double wall_seconds);
    double played_seconds(double wall_seconds);
    double shown_seconds(double played, double wall_seconds);
    PlayedFrame moved_to(double end);

    static constexpr std::size_t frames_remembered = 1024;
    static constexpr double longest_frame = 0.25;  // s

    std::shared_ptr<const Signal> m_signal;  // shared with its loudness
    std::shared_ptr<const SampleStream> m_heard_stream;
    std::shared_ptr<const Loudness> m_loudness;
    std::shared_ptr<const SoundTexels> m_sound_texels;
    PlayedSound m_sound;
    std::unique_ptr<SoundDevices> m_devices;
    SoundSettings m_settings;
    std::unique_ptr<SoundOutput> m_output;
    std::unique_ptr<SoundCapture> m_capture;  // while live input is drawn and not muted
    bool m_is_input_muted = false;
    int m_channels = 0;             // requested from the capture
    std::int64_t m_live_first = 0;  // its frame at time 0
    double m_sender_patience = std::numeric_limits<double>::infinity();
    std::unique_ptr<BeamFeed> m_feed;        // while another program sends the beam
    std::unique_ptr<BeamPlayout> m_playout;  // while the beam is played on a device
    Spec m_spec;                             // of the signal, completed
    std::string m_silence;
    double m_speed = 1.0;
    double m_level = 1.0;
    double m_time = 0.0;
    double m_heard = 0.0;  // s of the output at the last query
    double m_start = 0.0;  // s in the sound at time 0
    double m_longest_frame = longest_frame;
    double m_shown_share = 1.0;
    double m_last_share = 1.0;  // of the last frame only
    std::int64_t m_frame = 0;
    bool m_is_playing = true;
    bool m_is_stepping = false;
    std::deque<PlayedFrame> m_past;
};
