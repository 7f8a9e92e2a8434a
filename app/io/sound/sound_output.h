#pragma once

#include "io/sound/sound_devices.h"

/// Opens the output device of the settings for a sound. Prints nothing to stderr.
Result<std::unique_ptr<SoundOutput>> open_sound_output(const SoundSettings& settings);
