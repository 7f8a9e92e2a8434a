#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// At the lower end of the picture while something is compared: with what, how the two are seen,
/// and what they come to.
void draw_compare_bar(const Scene& scene, Edits& edits);
/// How much of the picture it covers; 0 where nothing is compared.
float compare_bar_height(const Scene& scene);
