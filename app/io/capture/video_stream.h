#pragma once

#include "io/capture/video_capture.h"
#include "model/picture/live_spec.h"

#include <memory>
#include <string>
#include <vector>

/// How fast the pictures of a pipe are read.
enum class StreamPace {
    all,   // as fast as they are asked for, none is left out
    live,  // at their own rate
};

/// Video from standard input or a named pipe: y4m, or raw video with a size and a format. `rate`:
/// of its pictures, 1/s; 0: from the header, otherwise 60. Waits for the header. Errors have no
/// file.
Result<std::unique_ptr<VideoCapture>> open_pipe(const LiveSpec& spec, double rate, StreamPace pace);

/// Video from a camera. `rate`: pictures per second; 0: the camera's own. Errors have no file.
Result<std::unique_ptr<VideoCapture>> open_camera(const LiveSpec& spec, double rate);

/// The options of ffmpeg that open a camera.
std::vector<std::string> camera_options(const LiveSpec& spec, double rate);

/// Video that ffmpeg reads with these options for its input. `name`: for errors.
Result<std::unique_ptr<VideoCapture>> open_video_stream(const std::vector<std::string>& options,
                                                        const std::string& name);
