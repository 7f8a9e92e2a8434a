#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The preprocessed shaders of the inspected pass, each line with its origin. Click a line to open
/// its origin in the user's editor.
void draw_pass_text(const Scene& scene, Edits& edits);
