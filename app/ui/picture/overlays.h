#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Over the picture: the problems of the look, a replay that is under way, and the notice.
/// Whether what is wrong is told over the picture.
bool shows_errors(const Scene& scene);
void draw_overlays(const Scene& scene, Edits& edits);

/// In place of a picture, while no look is open.
void draw_welcome(const Scene& scene);
