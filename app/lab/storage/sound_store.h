#pragma once

#include "lab/storage/roots.h"
#include "model/devices/sound_settings.h"

/// The stored audio settings; the defaults if the file does not exist. A damaged file is an error
/// and is kept until new settings are saved.
Result<SoundSettings> load_sound_settings(const Roots& roots);
Result<void> save_sound_settings(const Roots& roots, const SoundSettings& settings);
