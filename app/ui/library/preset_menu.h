#pragma once

#include "lab/window/preset_list.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The context menu of a preset, on the last drawn item.
void draw_preset_menu(const ListedPreset& preset, const Scene& scene, Edits& edits);

/// Opens the preset, or the look without a preset. With `brings_content`, its own signal or source
/// is used even if the user's content is locked.
void open_listed(const ListedPreset& preset, const Scene& scene, Edits& edits,
                 bool brings_content = false);

/// Morphs to the preset in the time of the preset browser.
void morph_to_listed(const ListedPreset& preset, const Scene& scene, Edits& edits);

void star_listed(const ListedPreset& preset, Edits& edits);
