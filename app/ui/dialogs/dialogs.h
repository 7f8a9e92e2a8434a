#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Draws the open dialog, if any, above everything else.
void draw_dialogs(const Scene& scene, Edits& edits);
