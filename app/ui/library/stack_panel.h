#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The looks of the stack in drawing order, with controls to add, move, bypass and remove them.
void draw_stack_panel(const Scene& scene, Edits& edits);

/// Appends a look to the stack.
void add_to_stack(const ListedLook& look, Edits& edits);
