#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Play, step, restart, speed and time on the left; render size and zoom on the right.
void draw_transport_bar(const Scene& scene, Edits& edits);
