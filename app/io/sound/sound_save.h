#pragma once

#include "base/diagnostic.h"
#include "model/devices/sound.h"

#include <filesystem>

/// By extension: `.wav` with 32-bit floats, or `.flac` with 24 bits, clipped to -1..1. The same
/// samples give the same bytes; the write is atomic.
Result<void> save_sound(const Sound& sound, const std::filesystem::path& file);
