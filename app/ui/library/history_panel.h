#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// All undo and redo steps with their names and changes. Click a step to restore it.
void draw_history_panel(const Scene& scene, Edits& edits);
