#include "io/sound/sound_api.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <dlfcn.h>

namespace {
void say_nothing(const char*, int, const char*, int, const char*, ...) {}

// ALSA prints an error to stderr for each missing device. It is linked only if RtAudio was built
// with it, so its function is looked up by name.
void silence_alsa() {
    using SetHandler = int (*)(decltype(&say_nothing));
    if (void* const found = dlsym(RTLD_DEFAULT, "snd_lib_error_set_handler"))
        reinterpret_cast<SetHandler>(found)(say_nothing);
}
}  // namespace

std::vector<RtAudio::Api> usable_sound_apis() {
    silence_alsa();
    constexpr std::array wanted{RtAudio::LINUX_PULSE, RtAudio::LINUX_ALSA,  RtAudio::UNIX_JACK,
                                RtAudio::LINUX_OSS,   RtAudio::MACOSX_CORE, RtAudio::WINDOWS_WASAPI,
                                RtAudio::WINDOWS_DS};
    std::vector<RtAudio::Api> compiled;
    RtAudio::getCompiledApi(compiled);
    std::vector<RtAudio::Api> usable;
    std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(usable), [&](RtAudio::Api api) {
        return std::find(compiled.begin(), compiled.end(), api) != compiled.end();
    });
    return usable;
}

namespace {
unsigned int find_device(RtAudio& audio, const std::string& name, SoundDirection direction) {
    const bool is_out = direction == SoundDirection::out;
    if (name.empty())
        return is_out ? audio.getDefaultOutputDevice() : audio.getDefaultInputDevice();
    for (unsigned int device = 0; device < audio.getDeviceCount(); ++device) {
        const RtAudio::DeviceInfo info = audio.getDeviceInfo(device);
        if (info.name == name && (is_out ? info.outputChannels : info.inputChannels) > 0)
            return device;
    }
    throw RtAudioError(fmt::format("'{}' isn't connected", name));
}
}  // namespace

ChosenSoundDevice choose_sound_device(RtAudio& audio, const SoundSettings& settings,
                                      SoundDirection direction) {
    ChosenSoundDevice chosen;
    const bool is_out = direction == SoundDirection::out;
    chosen.id = find_device(audio, is_out ? settings.output : settings.input, direction);
    chosen.info = audio.getDeviceInfo(chosen.id);
    const unsigned int own =
        chosen.info.preferredSampleRate > 0 ? chosen.info.preferredSampleRate : 48000;
    chosen.rate = settings.rate > 0 ? static_cast<unsigned int>(settings.rate) : own;
    return chosen;
}

OpenedOutput open_stereo_output(RtAudio& audio, const SoundSettings& settings,
                                const std::string& name, RtAudioCallback fill, void* self) {
    const ChosenSoundDevice device = choose_sound_device(audio, settings, SoundDirection::out);
    RtAudio::StreamParameters parameters;
    parameters.deviceId = device.id;
    parameters.nChannels = 2;
    RtAudio::StreamOptions options;
    options.streamName = name;
    options.numberOfBuffers = 4;  // with the default a sound server buffers seconds
    auto frames = static_cast<unsigned int>(settings.buffer);
    audio.openStream(&parameters, nullptr, RTAUDIO_FLOAT32, device.rate, &frames, fill, self,
                     &options, ignore_while_running);
    const double buffered = static_cast<double>(frames) * options.numberOfBuffers / device.rate;
    return {device.info.name, device.rate, buffered};
}

void ignore_while_running(RtAudioError::Type, const std::string&) {}

Result<void> try_sound_apis(SoundDirection direction,
                            const std::function<bool(RtAudio::Api)>& open) {
    const bool is_out = direction == SoundDirection::out;
    std::string reason = is_out ? "no audio device found" : "no audio input found";
    for (const RtAudio::Api api : usable_sound_apis()) {
        try {
            if (open(api))
                return {};
        } catch (const RtAudioError& error) {
            reason = is_out ? fmt::format("can't open the audio device: {}", error.getMessage())
                            : fmt::format("can't open the audio input: {}", error.getMessage());
        }
    }
    return fail({{}, 0, std::move(reason)});
}
