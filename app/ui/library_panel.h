#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// The looks, and under the open one its presets.
void draw_library_panel(const Scene& scene, Edits& edits);
