#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Every step of undo and redo by name, with what it changed; a click goes there.
void draw_history_panel(const Scene& scene, Edits& edits);
