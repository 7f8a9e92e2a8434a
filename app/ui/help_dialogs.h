#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// Every key and what it does.
void draw_keys_dialog(const Scene& scene, Edits& edits);

void draw_about_dialog(const Scene& scene, Edits& edits);
