#pragma once

#include "io/pictures/picture_reader.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// The extensions of videos: ".mp4".
const std::vector<std::string>& video_extensions();
/// Whether the extension is that of a video.
bool is_video_file(const std::filesystem::path& file);

/// The pictures of a video at a constant rate, display-encoded RGB, read by ffprobe and ffmpeg in
/// order of time. Reading backwards restarts from the beginning. Only the file itself is read, not
/// files that it refers to.
Result<std::unique_ptr<PictureReader>> open_video(const std::filesystem::path& file);
