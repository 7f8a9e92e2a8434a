#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// F10 opens the menus. While a menu, list or popup is open, the arrow keys, Enter and Escape move
/// in it, and shortcuts are inactive. Call it in the menu bar, before the first menu, named
/// `first`.
void follow_menu_keys(const char* first, const Scene& scene, Edits& edits);

/// Whether ImGui's keyboard navigation covers all controls. It is normally off, because the
/// parameters use the arrow keys.
void set_keyboard_navigation(bool is_enabled);
