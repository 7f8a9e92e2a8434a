#pragma once

#include "base/diagnostic.h"
#include "io/sound/beam_queue.h"
#include "model/devices/live_sound.h"
#include "model/devices/sound.h"
#include "model/devices/sound_settings.h"

#include <memory>
#include <string>
#include <vector>

/// A device of the machine. What other programs play can be recorded from a monitor, an input.
struct SoundDevice {
    std::string name;
    bool has_output = false;
    bool has_input = false;
    bool is_default_output = false;
    bool is_default_input = false;

    bool operator==(const SoundDevice&) const = default;
};

/// A device that plays one sound, for as long as this lives.
class SoundOutput {
public:
    virtual ~SoundOutput() = default;

    virtual std::string device_name() const = 0;

    /// The part from `start_seconds` on: its time 0, and where it loops to. Null is silence. The
    /// sound has a rate and a channel.
    virtual void play(std::shared_ptr<const Sound> sound, double start_seconds) = 0;
    /// Goes on after pause().
    virtual void play() = 0;
    virtual void pause() = 0;
    /// Goes on at this time of the sound; when it loops, also one beyond its end.
    virtual void seek(double seconds) = 0;
    /// Off at first.
    virtual void set_loop(bool loops) = 0;
    /// 0 .. 2, at first 1.
    virtual void set_level(double level) = 0;
    /// 0.01 .. 4, at first 1; the pitch follows.
    virtual void set_speed(double speed) = 0;

    /// The time in the sound of what is heard now: a clock to go by. It goes on counting from loop
    /// to loop and never runs back but by seek() and play(sound); at the end of a sound that does
    /// not loop it stands still.
    virtual double position_seconds() = 0;
    /// Whether the device has asked for nothing for a second, or its server died.
    virtual bool has_stalled() const = 0;
};

/// A sound that comes in from a device for as long as this lives.
class SoundCapture {
public:
    virtual ~SoundCapture() = default;

    virtual std::string device_name() const = 0;
    virtual std::shared_ptr<const LiveSound> sound() const = 0;
    /// How much of the sound may be shown by now: a clock that runs evenly, a little behind what
    /// has come in.
    virtual double position_seconds() = 0;
    /// Whether nothing has come in for a second, or its server died.
    virtual bool has_stalled() const = 0;
};

/// A device that plays a beam, sample by sample, for as long as this lives.
class BeamOutput {
public:
    virtual ~BeamOutput() = default;

    virtual std::string device_name() const = 0;
    virtual int rate() const = 0;  // samples a second
    /// Where what is written goes.
    virtual BeamQueue& queue() = 0;
    /// Whether the device has asked for nothing for a second, or its server died.
    virtual bool has_stalled() const = 0;
};

/// The sound devices that there are. Tests have some of their own.
class SoundDevices {
public:
    virtual ~SoundDevices() = default;

    virtual std::vector<SoundDevice> list() = 0;
    /// Each says why it cannot be had, and writes nothing to stderr.
    virtual Result<std::unique_ptr<SoundOutput>> open_output(const SoundSettings& settings) = 0;
    virtual Result<std::unique_ptr<BeamOutput>> open_beam_output(const SoundSettings& settings) = 0;
    /// With so many channels, at least 2, or as many as the device has.
    virtual Result<std::unique_ptr<SoundCapture>> open_capture(const SoundSettings& settings,
                                                               int channels) = 0;
};

/// Those of this machine.
std::unique_ptr<SoundDevices> machine_sound_devices();
