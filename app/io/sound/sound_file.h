#pragma once

#include "base/diagnostic.h"
#include "base/work.h"
#include "model/devices/sound.h"

#include <filesystem>

/// The longest sound that is read, and the most memory that its samples may take.
inline constexpr int most_sound_seconds = 3600;
inline constexpr std::size_t most_sound_samples = std::size_t{1} << 29;  // 2 GiB

/// Decodes a WAV, FLAC, OGG or MP3 file (and what else libsndfile reads) as it is: no mixing, no
/// other rate. Samples that are not finite become 0. At most 8 channels, 1 h and 2 GiB; of a file
/// that breaks off, what is there, and a note that says how much. Fails when `work` is cancelled.
Result<Sound> load_sound(const std::filesystem::path& file, Work* work = nullptr,
                         Diagnostics* notes = nullptr);
