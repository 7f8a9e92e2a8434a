#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Pen, keyframes and files of a drawing, as part of the signal panel.
void draw_drawing_panel(const Scene& scene, Edits& edits);
