#pragma once

#include "base/diagnostic.h"
#include "model/devices/sound.h"

#include <filesystem>

/// By extension: `.wav` of 32-bit floats, or `.flac` of 24 bits, where what is beyond -1..1 is cut
/// off. The same samples give the same bytes; atomic.
Result<void> save_sound(const Sound& sound, const std::filesystem::path& file);
