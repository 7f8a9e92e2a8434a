#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The submenu of stored unsaved changes: picture, look, preset, number of changes and age.
void draw_unsaved_menu(const Scene& scene, Edits& edits);
