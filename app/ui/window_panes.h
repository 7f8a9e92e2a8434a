#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// The whole window of one frame: menu, panes, splitters and dialogs.
void draw_window(const Scene& scene, Edits& edits);
