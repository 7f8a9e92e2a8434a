#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The looks, and the presets of the open look below it.
void draw_library_panel(const Scene& scene, Edits& edits);
