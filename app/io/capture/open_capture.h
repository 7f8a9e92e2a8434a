#pragma once

#include "io/capture/video_capture.h"
#include "model/picture/live_spec.h"

#include <memory>

/// Opens a live source: a window, the screen, a camera or a pipe. `rate`: of a camera or pipe, as
/// in SourceSpec. Errors have no file and say what is missing.
Result<std::unique_ptr<VideoCapture>> open_capture(const LiveSpec& spec, double rate);
