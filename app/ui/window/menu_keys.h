#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// F10 opens the menus for the arrow keys, Enter and Escape. Other keys are inactive until the
/// menus are closed. Call it in the menu bar, before the first menu, named `first`.
void follow_menu_keys(const char* first, const Scene& scene, Edits& edits);
