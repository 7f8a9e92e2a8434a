#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The command palette: a line to type into, and what fits it.
void draw_palette_dialog(const Scene& scene, Edits& edits);
