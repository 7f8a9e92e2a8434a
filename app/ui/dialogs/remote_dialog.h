#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// What other programs may turn, and what has come from them.
void draw_remote_dialog(const Scene& scene, Edits& edits);
