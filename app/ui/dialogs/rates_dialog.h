#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Begins to compare what several frame rates make of the picture, and shows the dialog.
void compare_rates(Edits& edits);

/// How far it has come, with a way out; then which rates differ by how much, and where.
void draw_rates_dialog(const Scene& scene, Edits& edits);
