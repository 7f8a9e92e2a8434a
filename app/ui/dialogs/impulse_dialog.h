#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Fires a flash at the first pin, else at the pixel under the pointer, else in the middle, and
/// shows the dialog.
void fire_impulse(const Scene& scene, Edits& edits);

/// How the flash falls in every pass: a plot over time, and a table of times.
void draw_impulse_dialog(const Scene& scene, Edits& edits);
