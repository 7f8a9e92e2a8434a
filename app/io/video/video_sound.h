#pragma once

#include "base/diagnostic.h"
#include "io/system/child_process.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>

/// What a video is as long as, and whether it can be heard.
struct VideoTimes {
    double seconds = 0.0;  // 0: unknown
    bool has_sound = false;
};

/// Read by ffprobe. Only the file itself is read.
Result<VideoTimes> video_times(const std::filesystem::path& file);

/// The first sound of a video as stereo floats, decoded by ffmpeg in order of time.
class VideoSound {
public:
    static constexpr int rate = 48000;  // samples per second

    /// From `start_seconds` on. Fails without ffmpeg.
    static Result<std::unique_ptr<VideoSound>> open(const std::filesystem::path& file,
                                                    double start_seconds);

    /// The next samples, left and right in turn; 0 after the end.
    void read(std::span<float> samples);

private:
    explicit VideoSound(ChildProcess process) : m_process(std::move(process)) {}

    ChildProcess m_process;
};
