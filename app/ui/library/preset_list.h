#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The presets of the open look with small pictures: default, the user's, the shipped ones. Search
/// and favourites filter are those of the preset browser.
void draw_preset_list(const Scene& scene, Edits& edits);
