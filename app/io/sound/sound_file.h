#pragma once

#include "base/diagnostic.h"
#include "base/job_progress.h"
#include "model/devices/sound.h"

#include <filesystem>

/// The longest sound that is read, and the maximum number of its samples.
inline constexpr int max_sound_seconds = 3600;
inline constexpr std::size_t max_sound_samples = std::size_t{1} << 29;  // 2 GiB

/// Decodes a WAV, FLAC, OGG or MP3 file (and others that libsndfile reads) without mixing or
/// resampling. Samples that are NaN become 0, others are clamped. At most 32 channels, 1 h and 2
/// GiB. A truncated file is read as far as possible, with a note of its length. Fails when `work`
/// is cancelled.
Result<Sound> load_sound(const std::filesystem::path& file, JobProgress* work = nullptr,
                         Diagnostics* notes = nullptr);
