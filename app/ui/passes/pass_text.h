#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The shaders of the chosen pass as the driver got them, each line with where it was written. A
/// click on a line opens that place in the person's editor.
void draw_pass_text(const Scene& scene, Edits& edits);
