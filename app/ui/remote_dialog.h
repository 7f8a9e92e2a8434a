#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// What other programs may turn, and what has come from them.
void draw_remote_dialog(const Scene& scene, Edits& edits);
