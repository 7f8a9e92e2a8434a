#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The looks, and under the open one its presets.
void draw_library_panel(const Scene& scene, Edits& edits);
