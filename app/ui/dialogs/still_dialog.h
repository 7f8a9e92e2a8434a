#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The dialog that saves the picture, in its size or drawn again in another one.
void draw_still_dialog(const Scene& scene, Edits& edits);
