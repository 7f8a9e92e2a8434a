#include "io/sound/sound_devices.h"

#include "io/sound/sound_api.h"
#include "io/sound/sound_beam.h"
#include "io/sound/sound_capture.h"
#include "io/sound/sound_output.h"

namespace {
class MachineSoundDevices : public SoundDevices {
public:
    // From the first API that has devices, the order that open_output() and open_capture() use.
    std::vector<SoundDevice> list() override {
        std::vector<SoundDevice> devices;
        for (const RtAudio::Api api : usable_sound_apis()) {
            try {
                RtAudio audio(api);
                audio.showWarnings(false);
                for (unsigned int i = 0; i < audio.getDeviceCount(); ++i)
                    if (const auto info = audio.getDeviceInfo(i); info.probed)
                        devices.push_back({info.name, info.outputChannels > 0,
                                           info.inputChannels > 0, info.isDefaultOutput,
                                           info.isDefaultInput});
            } catch (const RtAudioError&) {
                continue;  // the server isn't running
            }
            if (!devices.empty())
                break;
        }
        return devices;
    }

    Result<std::unique_ptr<SoundOutput>> open_output(const SoundSettings& settings) override {
        return open_sound_output(settings);
    }

    Result<std::unique_ptr<BeamOutput>> open_beam_output(const SoundSettings& settings) override {
        return open_sound_beam(settings);
    }

    Result<std::unique_ptr<SoundCapture>> open_capture(const SoundSettings& settings,
                                                       int channels) override {
        return open_sound_capture(settings, channels);
    }
};
}  // namespace

std::unique_ptr<SoundDevices> machine_sound_devices() {
    return std::make_unique<MachineSoundDevices>();
}
