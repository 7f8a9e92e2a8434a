#pragma once

#include "ui/scene.h"

/// The pace of the window's frames, the time of each pass, draw calls and memory.
void draw_timings_panel(const Scene& scene);
