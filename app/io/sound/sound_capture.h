#pragma once

#include "io/sound/sound_devices.h"

/// Opens the input device of the settings.
Result<std::unique_ptr<SoundCapture>> open_sound_capture(const SoundSettings& settings,
                                                         int channels);
