#pragma once

#include "io/sound/sound_devices.h"

/// The output device that the settings name, for a sound. An error says why it cannot be had;
/// nothing is written to stderr.
Result<std::unique_ptr<SoundOutput>> open_sound_output(const SoundSettings& settings);
