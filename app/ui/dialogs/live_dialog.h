#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Asks for a window, the screen, a camera or a pipe as the source.
void draw_live_dialog(const Scene& scene, Edits& edits);
