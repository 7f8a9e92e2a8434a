#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The looks that are drawn one after the other: to be added, moved, bypassed and removed.
void draw_stack_panel(const Scene& scene, Edits& edits);

/// One look more, behind those that are there.
void add_to_stack(const ShelfLook& look, Edits& edits);
