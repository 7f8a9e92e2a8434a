#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Whether errors are displayed over the picture.
bool shows_errors(const Scene& scene);
/// Draws everything over the picture: first steps, errors, progress and notices.
void draw_overlays(const Scene& scene, Edits& edits);

/// The text that replaces the picture while no look is open.
void draw_welcome(const Scene& scene);
