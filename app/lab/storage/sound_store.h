#pragma once

#include "lab/storage/roots.h"
#include "model/devices/sound_settings.h"

/// The sound devices that the person has chosen; at first the system's own. A damaged file is an
/// error, and left as it is until other devices are chosen.
Result<SoundSettings> load_sound_settings(const Roots& roots);
Result<void> save_sound_settings(const Roots& roots, const SoundSettings& settings);
