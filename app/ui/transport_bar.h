#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// Play, step, restart, speed and time on the left; size and zoom of the picture on the right.
void draw_transport_bar(const Scene& scene, Edits& edits);
