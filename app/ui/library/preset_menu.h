#pragma once

#include "lab/window/preset_list.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// What can be done with a preset, behind the right button on the item that was drawn last.
void draw_preset_menu(const ListedPreset& preset, const Scene& scene, Edits& edits);

/// Opens it, or the look without one. `brings_content`: with its own signal or source, also where
/// the user's is locked.
void open_listed(const ListedPreset& preset, const Scene& scene, Edits& edits,
                 bool brings_content = false);

void star_listed(const ListedPreset& preset, Edits& edits);
