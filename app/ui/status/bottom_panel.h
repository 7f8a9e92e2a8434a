#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Problems or timings, as chosen in its first line.
void draw_bottom_panel(const Scene& scene, Edits& edits);

/// The line at the very bottom: problems, pace, memory, and what is under the pointer.
void draw_status_bar(const Scene& scene, Edits& edits);
