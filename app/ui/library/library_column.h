#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Two panes in the current window: the looks with the presets, and stack and signal below them.
void draw_library_column(const Scene& scene, Edits& edits);
