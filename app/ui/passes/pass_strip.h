#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// All passes in order: current picture, name, size, format and time. Click a pass to inspect it.
void draw_pass_strip(const Scene& scene, Edits& edits);
