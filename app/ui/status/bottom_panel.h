#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The bottom pane with the part that is chosen in its first line, such as problems or timings.
void draw_bottom_panel(const Scene& scene, Edits& edits);

/// The status bar: problems, frame rate, cost of a frame and the probed pixel.
void draw_status_bar(const Scene& scene, Edits& edits);
