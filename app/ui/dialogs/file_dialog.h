#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Chooses a file to open, or a name to save under: a folder's listing, its path and a name.
void draw_file_dialog(const Scene& scene, Edits& edits);
