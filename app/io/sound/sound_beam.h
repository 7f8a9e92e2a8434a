#pragma once

#include "io/sound/sound_devices.h"

/// Opens the output device of the settings for a beam.
Result<std::unique_ptr<BeamOutput>> open_sound_beam(const SoundSettings& settings);
