#pragma once

#include "base/diagnostic.h"
#include "model/sound.h"
#include "model/sound_settings.h"

#include <memory>
#include <string>

/// The sound device of the machine, playing one sound.
class SoundOutput {
public:
    /// Says why the device cannot be had; writes nothing to stderr.
    static Result<std::unique_ptr<SoundOutput>> open(const SoundSettings& settings = {});
    ~SoundOutput();
    SoundOutput(const SoundOutput&) = delete;
    SoundOutput& operator=(const SoundOutput&) = delete;

    std::string device_name() const;

    /// The part from `start_seconds` on: its time 0, and where it loops to. Null is silence. The
    /// sound has a rate and a channel.
    void play(std::shared_ptr<const Sound> sound, double start_seconds = 0.0);
    /// Goes on after pause().
    void play();
    void pause();
    /// Goes on at this time of the sound; when it loops, also one beyond its end.
    void seek(double seconds);
    /// Off at first.
    void set_loop(bool loops);
    /// 0 .. 2, at first 1.
    void set_level(double level);
    /// 0.01 .. 4, at first 1; the pitch follows.
    void set_speed(double speed);

    /// The time in the sound of what is heard now: a clock to go by. It goes on counting from loop
    /// to loop and never runs back but by seek() and play(sound); at the end of a sound that does
    /// not loop it stands still.
    double position_seconds() const;
    /// Whether the device has asked for nothing for a second (it was pulled out, or its server
    /// died); the clock then stands still for good.
    bool has_stalled() const;

private:
    class Device;
    explicit SoundOutput(std::unique_ptr<Device> device);

    std::unique_ptr<Device> m_device;
};
