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

/// One frame on the player's clock.
struct PlayedFrame {
    std::int64_t number = 0;  // from 1 after a restart
    TimeSpan span;
};

/// A sound, or a scene or drawing, that was read from a file.
struct PlayedSound {
    std::filesystem::path file;
    std::shared_ptr<const Sound> sound;           // shared with the sound device's thread
    std::shared_ptr<const BeamScene> scene = {};  // shared with the reading thread
    std::shared_ptr<const Drawing> drawing = {};  // likewise
};

/// The clock, and the signal that it runs over.
class Player {
public:
    /// Only where a person listens are there sound devices; null: none are used.
    explicit Player(std::unique_ptr<SoundDevices> devices = nullptr)
        : m_devices(std::move(devices)) {}

    /// Makes the signal of the spec the current one, over `sound` if its kind plays one; a spec
    /// without a kind is no signal. On an error the old signal goes on.
    Result<void> set_signal(const Spec& spec, PlayedSound sound = {});
    const Signal* signal() const { return m_signal.get(); }
    const PlayedSound& sound() const { return m_sound; }
    /// How much of the sound is played, in seconds; 0 without a sound.
    double sound_seconds() const;
    /// Why a sound that should be heard or come in does not, or what is wrong with a beam that
    /// another program sends; "" when all is well.
    std::string silence() const;
    /// The device that a live sound comes in from; "" when none does.
    std::string live_device() const { return m_capture ? m_capture->device_name() : ""; }

    /// While muted no live sound comes in, and its device stays closed.
    bool is_input_muted() const { return m_is_input_muted; }
    /// Opens the device of a live sound that is drawn, or closes it.
    Result<void> mute_input(bool is_muted);
    /// Whether a live sound is drawn, and muted.
    bool draws_muted_input() const;

    /// Whether the beam of another program is drawn or waited for; "" where there is none.
    std::string sent_state() const { return m_feed ? m_feed->state() : std::string(); }
    /// What could not be read of a beam that another program sends.
    Diagnostics sent_problems() const { return m_feed ? m_feed->problems() : Diagnostics(); }
    /// As BeamFeed::state(); "" without one.
    std::string sender_state() const { return m_feed ? m_feed->state() : std::string(); }
    /// As SentBeam::set_patience(), for senders from now on.
    void set_sender_patience(double seconds) { m_sender_patience = seconds; }

    /// The device that the beam is played on; "" when it is none.
    std::string beam_device() const { return m_playout ? m_playout->device_name() : ""; }

    const SoundSettings& sound_settings() const { return m_settings; }
    /// Opens the devices anew that are in use.
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
    /// As seek(), and as if up to so many frames had been shown before: there is a past to show.
    void seek_with_past(double seconds, std::size_t frames);
    void set_speed(double speed);  // 0.01 .. 4
    void set_level(double level);  // 0 .. 2, of the loudspeaker
    /// The next advance() goes one frame of 1/60 s further, also while paused.
    void step() { m_is_stepping = true; }
    /// Back to the end of a frame of the past, if it is still known.
    void go_back_to(std::int64_t frame);

    /// The frame that `wall_seconds` since the last call bring; none while paused or at the
    /// signal's end. While a sound is heard or comes in, its device is the clock.
    std::optional<PlayedFrame> advance(double wall_seconds);
    /// The frame of a fixed clock; time need not flow.
    PlayedFrame advance_fixed(double fps);

    /// The longest time that one frame may cover, 1/240 .. 1/4 s: a machine that takes longer shows
    /// time more slowly, or only a part of a sound that is heard; no frame holds light of two.
    void set_longest_frame(double seconds);
    /// How much of the time that goes by is shown, over about the last half second, or the last
    /// frame where that took longer: 1 where the machine keeps up. One frame alone that is held up
    /// counts as the one before.
    double shown_share() const { return m_shown_share; }
    /// Whether what is not shown is left out, because a sound that is heard, or a real scope, waits
    /// for nobody.
    bool leaves_out() const { return is_sound_the_clock() || m_playout; }

    Beam trace(const TimeSpan& span) const;
    /// The sound that a file's signal draws, as it is heard with it; null where there is none.
    std::shared_ptr<const SampleStream> heard() const { return m_heard_stream; }
    /// Of the sound that is drawn, else of the signal; null where there is none, or where it comes
    /// from another program, point by point. Shared with who draws.
    std::shared_ptr<const Loudness> loudness() const { return m_loudness; }
    /// The same for textures that follow the sound; of a signal that is no sound x is heard on the
    /// left and y on the right.
    std::shared_ptr<const SoundTexels> sound_texels() const { return m_sound_texels; }

    /// The latest frames, oldest first, for showing again what led to the present picture.
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

    std::shared_ptr<const Signal> m_signal;  // with its loudness
    std::shared_ptr<const SampleStream> m_heard_stream;
    std::shared_ptr<const Loudness> m_loudness;
    std::shared_ptr<const SoundTexels> m_sound_texels;
    PlayedSound m_sound;
    std::unique_ptr<SoundDevices> m_devices;
    SoundSettings m_settings;
    std::unique_ptr<SoundOutput> m_output;
    std::unique_ptr<SoundCapture> m_capture;  // while a live sound is drawn and not muted
    bool m_is_input_muted = false;
    int m_channels = 0;             // that were asked of it
    std::int64_t m_live_first = 0;  // its frame at time 0
    double m_sender_patience = std::numeric_limits<double>::infinity();
    std::unique_ptr<BeamFeed> m_feed;        // while another program sends the beam
    std::unique_ptr<BeamPlayout> m_playout;  // while the beam goes out to a real scope
    Spec m_spec;                             // of the signal, complete
    std::string m_silence;
    double m_speed = 1.0;
    double m_level = 1.0;
    double m_time = 0.0;
    double m_heard = 0.0;  // s of the output when last asked
    double m_start = 0.0;  // s into the sound where time 0 is
    double m_longest_frame = longest_frame;
    double m_shown_share = 1.0;
    double m_last_share = 1.0;  // of the last frame alone
    std::int64_t m_frame = 0;
    bool m_is_playing = true;
    bool m_is_stepping = false;
    std::deque<PlayedFrame> m_past;
};
