#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Ticks off what the person has done.
void note_first_steps(const Lab& lab, WindowState& window);

/// At the very first start, in a corner of the picture: three things to do.
void draw_first_steps(const Scene& scene, Edits& edits);
