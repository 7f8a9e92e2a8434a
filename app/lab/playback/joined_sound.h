#pragma once

#include "base/diagnostic.h"
#include "model/devices/sound.h"

#include <filesystem>
#include <vector>

/// Appends `next` without a gap. Mono becomes stereo if the other sound has two channels. Error:
/// another sample rate, other channels, or more than max_sound_samples; then `sound` is unchanged.
Result<void> append_sound(Sound& sound, const Sound& next);

/// Reads sounds and joins them in this order. Errors name the file.
Result<Sound> load_joined_sound(const std::vector<std::filesystem::path>& files,
                                Diagnostics* notes = nullptr);
