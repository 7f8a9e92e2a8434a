#pragma once

#include "lab/messages/choice.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Does what was chosen.
void run(const Deeds& deeds, Edits& edits);

/// The same, or asks first for the number or the words that it needs. `id`: of its palette entry.
void take(const Choice& choice, const std::string& id, Edits& edits);

/// A submenu for each list of that menu.
void draw_choice_menus(ChoiceList::Place place, const Scene& scene, Edits& edits);
