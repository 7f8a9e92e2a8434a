#pragma once

#include "io/capture/video_capture.h"

#include <memory>

/// The picture of a window of another program, also where other windows cover it. `title`: its
/// title, or a part of it in any case; an equal title wins, then the topmost window. Errors have no
/// file and list the windows.
Result<std::unique_ptr<VideoCapture>> capture_window(const std::string& title);
