#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Three panes in the current window: looks, presets, and stack and signal. Their heights depend
/// only on the window, so nothing moves when a look opens.
void draw_library_column(const Scene& scene, Edits& edits);
