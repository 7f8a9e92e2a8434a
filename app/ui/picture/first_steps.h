#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Marks the steps that the user has done.
void note_first_steps(const Document* document, WindowState& window);

/// Three suggested steps in a corner of the picture, on the first start only.
void draw_first_steps(const Scene& scene, Edits& edits);
