#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// A line to type the number or the words that a choice needs.
void draw_asked_dialog(const Scene& scene, Edits& edits);
