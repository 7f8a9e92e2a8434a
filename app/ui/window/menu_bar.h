#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The menu bar from the action table, with the title of the open look at its right end.
void draw_menu_bar(const Scene& scene, Edits& edits);

/// "Phosphor – amber •": the look, its preset, and a mark for unsaved changes.
std::string title_of(const Document* document);
