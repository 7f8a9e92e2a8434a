#pragma once

#include "ui/frame/action.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The submenus of the menu File that follow an action: recent files, unsaved changes, morph.
void draw_file_submenus(const Action& after, const Scene& scene, Edits& edits);
