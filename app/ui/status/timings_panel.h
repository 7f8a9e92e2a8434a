#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Whether the passes exceed the time budget; false while paused.
bool is_over_budget(const Scene& scene);
/// Frame times of the window, GPU times of all passes against the budget, and of each pass.
void draw_timings_panel(const Scene& scene, Edits& edits);
