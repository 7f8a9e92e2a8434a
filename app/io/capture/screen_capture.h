#pragma once

#include "io/capture/video_capture.h"
#include "model/picture/live_spec.h"

#include <memory>

/// The picture of a screen or of a part of it. Where windows of this process lie, the picture stays
/// as it was. Errors have no file.
Result<std::unique_ptr<VideoCapture>> capture_screen(const LiveSpec& spec);
