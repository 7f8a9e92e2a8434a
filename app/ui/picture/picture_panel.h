#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/widgets/widgets.h"

/// The picture, and over it what is wrong with the look and what has just happened.
void draw_picture_panel(const Scene& scene, const Rect& place, Edits& edits);
