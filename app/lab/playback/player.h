#pragma once

#include "base/diagnostic.h"
#include "lab/playback/audio_devices.h"
#include "lab/playback/played_signal.h"
#include "lab/playback/transport.h"

#include <limits>
#include <memory>
#include <optional>
#include <string>

/// Plays a signal: its clock, its input and its audio devices.
class Player {
public:
    /// `devices` are for the window; null: no audio devices are used. `sender_timeout` is that of
    /// PlayedSignal.
    explicit Player(std::unique_ptr<SoundDevices> devices = nullptr,
                    double sender_timeout = std::numeric_limits<double>::infinity());

    const Transport& transport() const { return m_transport; }
    const PlayedSignal& signal() const { return m_signal; }
    const AudioDevices& devices() const { return m_devices; }

    /// Sets the signal of a spec, with `sound` if its kind plays one. A spec without a kind means
    /// no signal. On an error the previous signal stays.
    Result<void> set_signal(const Spec& spec, SignalFile sound = {});
    /// Closes or opens the device of the live input.
    Result<void> mute_input(bool is_muted);
    /// Reopens the devices in use.
    Result<void> set_sound_settings(const SoundSettings& settings);
    /// The error of sound output, live input or the beam of another program; "": no error.
    std::string error() const;

    void play();
    void pause();
    /// The next advance() covers one frame of 1/60 s, even while paused.
    void step() { m_transport.step(); }
    void restart();
    void seek(double seconds);
    /// As Transport::restart(), for offline drawing.
    void skip_to(std::int64_t after, int subframes) { m_transport.restart(after, subframes); }
    /// As seek(), with a past of up to this number of frames, so that they can be replayed.
    void seek_with_past(double seconds, std::size_t frames);
    /// Seeks to the end of a past frame, if it is still stored.
    void go_back_to(std::int64_t frame);
    void set_speed(double speed);                                 // 0.01 to 4
    void set_level(double level) { m_devices.set_level(level); }  // 0 to 2, volume of the sound
    /// The longest time that one frame can cover, 1/240 to 1/4 s. On a slower machine, playback is
    /// slower, or part of a playing sound is not drawn.
    void set_longest_frame(double seconds) { m_transport.set_longest_frame(seconds); }

    /// The frame for `wall_seconds` since the last call; nullopt: paused, or the signal has ended.
    /// While a sound plays or live input is drawn, its device is the clock. `subframes`: of each
    /// source frame that begins.
    std::optional<PlayedFrame> advance(double wall_seconds, int subframes = 1);
    /// The next frame of a fixed frame rate, for offline drawing.
    PlayedFrame advance_fixed(double fps, int subframes = 1);

private:
    Result<void> start(Spec complete, SignalFile sound);
    Result<void> play_beam();
    void report_stall();
    std::optional<PlayedFrame> advance_clock(double wall_seconds);
    std::optional<PlayedFrame> advance_live(double wall_seconds);

    Transport m_transport;
    AudioDevices m_devices;
    PlayedSignal m_signal;
    std::string m_error;  // of a device; "": none
};
