#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The dialog that adds a video or an image sequence to the queue of exports.
void draw_export_dialog(const Scene& scene, Edits& edits);

/// Asks whether to quit although exports run.
void draw_quit_exporting_dialog(const Scene& scene, Edits& edits);
