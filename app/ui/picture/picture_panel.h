#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/widgets/widgets.h"

/// The picture with overlays for problems and notices.
void draw_picture_panel(const Scene& scene, const Rect& rect, Edits& edits);
