#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <string>
#include <vector>

/// FFmpeg's names of the formats in is_video_file(). A playlist with such a name would open other
/// files (hls, concat, dash, imf), and so would an image sequence.
inline constexpr const char* video_formats =
    "mov,matroska,avi,mpeg,mpegvideo,mpegts,m4v,ogg,gif,yuv4mpegpipe";

/// Marks a path as a file for FFmpeg, even if its name starts like a protocol.
std::string video_input(const std::filesystem::path& file);

/// The error if ffmpeg or ffprobe could not be started.
tl::unexpected<Diagnostics> without_ffmpeg(const std::filesystem::path& file,
                                           const Diagnostics& reasons);

/// The output of ffprobe for a video, with further options. Only the file itself is read.
Result<std::string> probe_video(const std::filesystem::path& file,
                                const std::vector<std::string>& options);
/// A complaint of ffmpeg or ffprobe about a file, without its name.
std::string without_name(const std::string& complaint, const std::filesystem::path& file);
