#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Draws the whole window: menu, panes, splitters and dialogs.
void draw_window(const Scene& scene, Edits& edits);
