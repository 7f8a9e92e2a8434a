#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The inspected pass, large: exposure, single channels, zoom to texels, and the values under the
/// pointer. Its scale, format and filter can be tried and saved.
void draw_inspector_panel(const Scene& scene, Edits& edits);
