#pragma once

#include "lab/messages/choice.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Runs the effects of a choice.
void run(const MenuCommands& commands, Edits& edits);

/// Runs the choice, or first opens a dialog if it needs a number or text. `id`: its palette entry.
void take(const Choice& choice, const std::string& id, Edits& edits);

/// A submenu for each list of choices of that menu.
void draw_choice_menus(ChoiceList::Place place, const Scene& scene, Edits& edits);
