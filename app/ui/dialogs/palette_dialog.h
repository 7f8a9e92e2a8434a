#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The command palette: a search field and the matching entries.
void draw_palette_dialog(const Scene& scene, Edits& edits);
