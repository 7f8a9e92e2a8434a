#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The picture that the open look works on, and how it lies in what is drawn.
void draw_source(const Scene& scene, Edits& edits);
