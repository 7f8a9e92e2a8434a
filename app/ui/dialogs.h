#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// The dialog that is open, if any, above all else.
void draw_dialogs(const Scene& scene, Edits& edits);
