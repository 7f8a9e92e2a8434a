#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The pen, its keyframes, and the files of a drawing: a part of the signal's pane.
void draw_drawing_panel(const Scene& scene, Edits& edits);
