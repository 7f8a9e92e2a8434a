#pragma once

#include "io/capture/video_capture.h"
#include "model/picture/live_spec.h"

#include <memory>

/// Whether the desktop shares its screen through a portal and PipeWire, as Wayland desktops do.
bool has_screen_cast();

/// The screen or window that the user chooses in a dialog of the desktop. Returns before that.
/// Errors have no file.
Result<std::unique_ptr<VideoCapture>> cast_screen(const LiveSpec& spec, CaptureMemory& memory);
