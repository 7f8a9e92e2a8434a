#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The buttons A, B and C. Empty slots are dim; a slot with the current values is highlighted. The
/// reference of the comparison is underlined.
void draw_slot_buttons(const Scene& scene, Edits& edits);
float slot_buttons_width();
