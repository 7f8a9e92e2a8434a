#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Draws an impulse at the first pin and shows the dialog. Without pins it uses the pixel under the
/// pointer, or else the centre.
void fire_impulse(const Scene& scene, Edits& edits);

/// The decay of the impulse in every pass: a plot over time and a table of times.
void draw_impulse_dialog(const Scene& scene, Edits& edits);
