#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The status bar: problems, frame rate, cost of a frame and the probed pixel.
void draw_status_bar(const Scene& scene, Edits& edits);
