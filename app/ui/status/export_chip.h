#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The progress of exports, with a button to cancel and the list of all exports. Draws nothing
/// while the list is empty.
void draw_export_chip(const Scene& scene, Edits& edits);
