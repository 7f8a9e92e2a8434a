#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The dialog that is open, if any, above all else.
void draw_dialogs(const Scene& scene, Edits& edits);
