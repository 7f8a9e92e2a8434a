#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// A, B and C in a row: what is empty is faint, what the present values are stands out, what is
/// compared with is underlined.
void draw_slot_buttons(const Scene& scene, Edits& edits);
float slot_buttons_width();
