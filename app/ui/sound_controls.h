#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// Where the sound is, with a bar to seek in, and how loud it plays.
void draw_sound_controls(const Scene& scene, Edits& edits);

/// "1:02.34".
std::string clock_text(double seconds);
