#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The menu bar, made from the table of actions; at its right end what is open.
void draw_menu_bar(const Scene& scene, Edits& edits);

/// "Phosphor – amber •": the look, its preset, and a mark when that is modified.
std::string title_of(const Lab& lab);
