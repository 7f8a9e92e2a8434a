#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The looks with small pictures, in an order that does not change, with search and recent looks.
void draw_library_panel(const Scene& scene, Edits& edits);
