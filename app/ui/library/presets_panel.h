#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The presets of the open look as pictures. Click to open one, Shift+click to morph to it.
void draw_presets_panel(const Scene& scene, Edits& edits);
