#pragma once

#include "io/capture/video_capture.h"
#include "model/picture/live_spec.h"

#include <memory>

/// Whether the desktop shares its screen through a portal and PipeWire, as Wayland desktops do.
bool has_screen_cast();

/// The screen or window that the user chooses in a dialog of the desktop. Returns before that.
/// While the program runs, the same is shared again without a question where the desktop allows it.
/// Errors have no file.
Result<std::unique_ptr<VideoCapture>> cast_screen(const LiveSpec& spec);

/// After the user has refused or has stopped sharing, cast_screen() fails until this is called: the
/// user has chosen the source again.
void allow_screen_cast_question();
