#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The whole window of one frame: menu, panes, splitters and dialogs.
void draw_window(const Scene& scene, Edits& edits);
