#pragma once

#include "io/sound/sound_devices.h"

/// A machine without audio devices.
class NoSoundDevices : public SoundDevices {
public:
    std::vector<SoundDevice> list() override { return {}; }
    Result<std::unique_ptr<SoundOutput>> open_output(const SoundSettings&) override {
        return fail({{}, 0, "no audio device found"});
    }
    Result<std::unique_ptr<BeamOutput>> open_beam_output(const SoundSettings&) override {
        return fail({{}, 0, "no audio device found"});
    }
    Result<std::unique_ptr<SoundCapture>> open_capture(const SoundSettings&, int) override {
        return fail({{}, 0, "no audio device found"});
    }
};
