#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// Over the picture: the problems of the look, a replay that is under way, and the notice.
void draw_overlays(const Scene& scene, Edits& edits);

/// In place of a picture, while no look is open.
void draw_welcome(const Scene& scene);
