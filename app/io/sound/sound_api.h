#pragma once

#include "base/diagnostic.h"
#include "model/devices/sound_settings.h"

#include <RtAudio.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

/// The usable APIs of RtAudio on this machine, sound servers first: they share a device with other
/// programs.
std::vector<RtAudio::Api> usable_sound_apis();

enum class SoundDirection { out, in };

/// A device and the rate to open it with: its preferred rate if the settings have none.
struct ChosenSoundDevice {
    unsigned int id = 0;
    RtAudio::DeviceInfo info;
    unsigned int rate = 0;  // samples per second
};

/// The device named by the settings, or the default. Throws RtAudioError, also if it is not found.
ChosenSoundDevice choose_sound_device(RtAudio& audio, const SoundSettings& settings,
                                      SoundDirection direction);

struct OpenedOutput {
    std::string device;
    unsigned int rate = 0;          // samples per second
    double buffered_seconds = 0.0;  // latency of the buffers
};

/// Opens a 32-bit float stereo output without starting it. `fill` gets `self` on the device's
/// thread. `name` is displayed by a sound server. Throws RtAudioError.
OpenedOutput open_stereo_output(RtAudio& audio, const SoundSettings& settings,
                                const std::string& name, RtAudioCallback fill, void* self);

/// The return value of a stream callback that ends the stream.
constexpr int end_of_stream = 2;

/// For openStream: without it RtAudio throws on the device's thread. DeviceWatch detects failures.
void ignore_while_running(RtAudioError::Type, const std::string&);

/// Calls `open` for each usable API until it returns true. Otherwise the error has the last reason.
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
