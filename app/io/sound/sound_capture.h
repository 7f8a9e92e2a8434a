#pragma once

#include "io/sound/sound_devices.h"

/// The input device that the settings name. An error says why it cannot be had.
Result<std::unique_ptr<SoundCapture>> open_sound_capture(const SoundSettings& settings,
                                                         int channels);
