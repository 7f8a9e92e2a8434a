#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The pace of the window's frames; the time of all passes against the budget, and of each in the
/// latest frames with its memory.
/// Whether the passes take longer than they may; never while nothing runs.
bool is_over_budget(const Scene& scene);
void draw_timings_panel(const Scene& scene, Edits& edits);
