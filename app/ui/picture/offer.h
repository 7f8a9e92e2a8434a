#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// A notice with buttons for its actions, near the bottom of the picture.
void draw_offer(const Notice& notice, const Scene& scene, Edits& edits);
