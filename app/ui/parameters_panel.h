#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// Every parameter of the open look by group, with a search box and resets.
void draw_parameters_panel(const Scene& scene, Edits& edits);
