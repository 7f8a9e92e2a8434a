#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// A line to type the number or the words that a choice needs.
void draw_asked_dialog(const Scene& scene, Edits& edits);
