#pragma once

#include "io/pictures/picture_reader.h"

#include <filesystem>
#include <memory>

/// Whether a file's name says that it is a video.
bool is_video_file(const std::filesystem::path& file);

/// The pictures of a video at its constant rate, display-encoded RGB, read by the programs ffprobe
/// and ffmpeg in the order of time; going back begins anew. Only the file itself is read, no other
/// that it names.
Result<std::unique_ptr<PictureReader>> open_video(const std::filesystem::path& file);
