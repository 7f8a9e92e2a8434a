#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// Every step of undo and redo by name, with what it changed; a click goes there.
void draw_history_panel(const Scene& scene, Edits& edits);
