#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The chosen pass, large: with exposure, one channel, zoom to its pixels and the numbers under the
/// pointer; and its scale, format and filter, to be tried and written back.
void draw_inspector_panel(const Scene& scene, Edits& edits);
