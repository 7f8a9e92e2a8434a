#pragma once

#include "ui/edits.h"
#include "ui/scene.h"
#include "ui/widgets.h"

/// The picture, and over it what is wrong with the look and what has just happened.
void draw_picture_panel(const Scene& scene, const Rect& place, Edits& edits);
