#pragma once

#include "base/diagnostic.h"
#include "model/picture/raw_picture.h"

#include <filesystem>
#include <optional>

/// Writes a picture as AVIF by ffmpeg: 10 bits, 4:4:4, BT.709 colours, without alpha. `quality` is
/// that of the codec, nullopt: its default. The write is atomic.
Result<void> save_avif(const RawPicture& picture, const std::filesystem::path& file,
                       std::optional<double> quality = std::nullopt);
