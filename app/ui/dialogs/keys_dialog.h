#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Lists every action with its key, and what the mouse does; both can be searched. Click a key to
/// change it.
void draw_keys_dialog(const Scene& scene, Edits& edits);
