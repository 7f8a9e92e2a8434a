#pragma once

#include "base/diagnostic.h"
#include "io/sound/beam_queue.h"
#include "model/devices/live_sound.h"
#include "model/devices/sound.h"
#include "model/devices/sound_settings.h"

#include <memory>
#include <string>
#include <vector>

/// A device of the machine. A monitor is an input that records what other programs play.
struct SoundDevice {
    std::string name;
    bool has_output = false;
    bool has_input = false;
    bool is_default_output = false;
    bool is_default_input = false;

    bool operator==(const SoundDevice&) const = default;
};

/// A device that plays one sound while this object lives.
class SoundOutput {
public:
    virtual ~SoundOutput() = default;

    virtual std::string device_name() const = 0;

    /// Plays the part from `start_seconds`, which is time 0 and the start of the loop, to
    /// `end_seconds`; 0: to the end. Null is silence. The sound has a rate and a channel.
    virtual void play(std::shared_ptr<const Sound> sound, double start_seconds,
                      double end_seconds) = 0;
    /// Resumes after pause().
    virtual void play() = 0;
    virtual void pause() = 0;
    /// Continues at this time of the sound; with a loop also beyond its end.
    virtual void seek(double seconds) = 0;
    /// Initially off.
    virtual void set_loop(bool loops) = 0;
    /// 0 .. 2, initially 1.
    virtual void set_level(double level) = 0;
    /// 0.01 .. 4, initially 1; changes the pitch too.
    virtual void set_speed(double speed) = 0;

    /// The time in the sound that is heard now, for use as a clock. It counts on from loop to loop
    /// and decreases only by seek() and play(sound). It stops at the end of a sound that does not
    /// loop.
    virtual double position_seconds() = 0;
    /// Whether the device has requested nothing for a second, or its server died.
    virtual bool has_stalled() const = 0;
};

/// Records sound from a device while this object lives.
class SoundCapture {
public:
    virtual ~SoundCapture() = default;

    virtual std::string device_name() const = 0;
    virtual std::shared_ptr<const LiveSound> sound() const = 0;
    /// The part of the sound that may be displayed now: a clock that runs smoothly, slightly later
    /// than the recorded end.
    virtual double position_seconds() = 0;
    /// Whether nothing was received for a second, or its server died.
    virtual bool has_stalled() const = 0;
};

/// A device that plays a beam, sample by sample, while this object lives.
class BeamOutput {
public:
    virtual ~BeamOutput() = default;

    virtual std::string device_name() const = 0;
    virtual int rate() const = 0;  // samples per second
    /// The queue to write samples to.
    virtual BeamQueue& queue() = 0;
    /// Whether the device has requested nothing for a second, or its server died.
    virtual bool has_stalled() const = 0;
};

/// Access to sound devices. Tests have their own implementation.
class SoundDevices {
public:
    virtual ~SoundDevices() = default;

    virtual std::vector<SoundDevice> list() = 0;
    /// Each reports errors in its Result, and prints nothing to stderr.
    virtual Result<std::unique_ptr<SoundOutput>> open_output(const SoundSettings& settings) = 0;
    virtual Result<std::unique_ptr<BeamOutput>> open_beam_output(const SoundSettings& settings) = 0;
    /// With `channels` channels (at least 2), or fewer if the device has fewer.
    virtual Result<std::unique_ptr<SoundCapture>> open_capture(const SoundSettings& settings,
                                                               int channels) = 0;
};

/// The sound devices of this machine.
std::unique_ptr<SoundDevices> machine_sound_devices();
