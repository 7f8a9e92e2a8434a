#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The bottom pane: the tabs of its panels in its first line, and the shown panel.
void draw_bottom_pane(const Scene& scene, Edits& edits);
