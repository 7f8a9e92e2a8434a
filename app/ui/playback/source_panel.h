#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The source picture of the open look and how it is fitted to the render size.
void draw_source(const Scene& scene, Edits& edits);
