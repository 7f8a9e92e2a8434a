#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Lists every keyboard shortcut.
void draw_keys_dialog(const Scene& scene, Edits& edits);

void draw_about_dialog(const Scene& scene, Edits& edits);
