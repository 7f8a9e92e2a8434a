#pragma once

#include "io/sound/sound_devices.h"

/// The output device that the settings name, for a beam. An error says why it cannot be had.
Result<std::unique_ptr<BeamOutput>> open_sound_beam(const SoundSettings& settings);
