#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Asks for the template and the folder name of a new look.
void draw_new_look_dialog(const Scene& scene, Edits& edits);
