#pragma once

#include "base/diagnostic.h"
#include "model/devices/sound_settings.h"

#include <RtAudio.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

/// What the sound library has for this machine, sound servers first: they share a device with other
/// programs.
std::vector<RtAudio::Api> usable_sound_apis();

enum class SoundDirection { out, in };

/// A device, and the rate to open it with: its own where the settings name none.
struct ChosenSoundDevice {
    unsigned int id = 0;
    RtAudio::DeviceInfo info;
    unsigned int rate = 0;  // samples a second
};

/// The device that the settings name, or the default. Throws RtAudioError, also when there is none.
ChosenSoundDevice choose_sound_device(RtAudio& audio, const SoundSettings& settings,
                                      SoundDirection direction);

struct OpenedOutput {
    std::string device;
    unsigned int rate = 0;          // samples a second
    double buffered_seconds = 0.0;  // that it may hold
};

/// Opens an output of 32-bit stereo, which is not started yet; `fill` gets `self` on the device's
/// thread. `name` is what a sound server shows. Throws RtAudioError.
OpenedOutput open_stereo_output(RtAudio& audio, const SoundSettings& settings,
                                const std::string& name, RtAudioCallback fill, void* self);

/// What a stream's function gives so that it is called no more.
constexpr int end_of_stream = 2;

/// For openStream: without it RtAudio throws in the device's thread. DeviceWatch sees a
/// failure.
void ignore_while_running(RtAudioError::Type, const std::string&);

/// Calls `open` for each usable API until it gives true. An error is its last reason for not doing
/// so.
Result<void> try_sound_apis(SoundDirection direction,
                            const std::function<bool(RtAudio::Api)>& open);

/// A Stream of the first API that has a device, started with `arguments`.
template <typename Stream, typename... Arguments>
Result<std::unique_ptr<Stream>> open_first_sound_device(SoundDirection direction,
                                                        const Arguments&... arguments) {
    std::unique_ptr<Stream> opened;
    const auto done = try_sound_apis(direction, [&](RtAudio::Api api) {
        auto stream = std::make_unique<Stream>(api);
        if (!stream->has_device())
            return false;
        stream->start(arguments...);
        if (!stream->is_running())
            return false;
        opened = std::move(stream);
        return true;
    });
    if (!done)
        return fail(done.error());
    return opened;
}
