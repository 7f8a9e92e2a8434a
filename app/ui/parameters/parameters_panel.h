#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// All parameters of the open look by group, with a search box and resets.
void draw_parameters_panel(const Scene& scene, Edits& edits);
