#pragma once

#include "lab/library/library_view.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Opens the dialog that lists how the open values differ from a preset.
void compare_preset(const ListedLookPreset& preset, const Scene& scene, Edits& edits);

void draw_compare_dialog(const Scene& scene, Edits& edits);
