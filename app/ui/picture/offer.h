#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// A notice with what may be done about it as buttons, low over the picture.
void draw_offer(const Notice& notice, const Scene& scene, Edits& edits);
