#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// F10 opens the menus for the arrow keys, Enter and Escape; no other key acts until they are
/// closed. To be called in the menu bar, before the first menu, which is called `first`.
void follow_menu_keys(const char* first, const Scene& scene, Edits& edits);
