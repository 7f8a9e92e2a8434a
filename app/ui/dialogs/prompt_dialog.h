#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// A dialog with an input line for the number or text that a menu entry needs.
void draw_asked_dialog(const Scene& scene, Edits& edits);
