#pragma once

#include "lab/messages/menu_entry.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Runs the commands of an entry.
void run(const std::vector<Edit>& commands, Edits& edits);

/// Runs the entry, or first opens a dialog if it needs a number or text. `id`: its palette entry.
void take(const MenuEntry& entry, const std::string& id, Edits& edits);

/// A submenu for each section of that menu.
void draw_menu_sections(MenuSection::Menu menu, const Scene& scene, Edits& edits);
