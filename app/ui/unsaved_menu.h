#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// The submenu of unsaved changes that are kept: picture, look, preset, number of changes and age.
void draw_unsaved_menu(const Scene& scene, Edits& edits);
