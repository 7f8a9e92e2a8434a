#pragma once

#include "base/diagnostic.h"

#include <filesystem>

/// What the header of a sound file says.
struct SoundInfo {
    double seconds = 0.0;  // 0: the header has no length
    int rate = 0;          // Hz
    int channels = 0;
};

/// Reads only the header. Fails for files that libsndfile does not read.
Result<SoundInfo> load_sound_info(const std::filesystem::path& file);
