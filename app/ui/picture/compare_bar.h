#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The bar at the bottom of the picture during a comparison: reference, compare mode and measured
/// differences.
void draw_compare_bar(const Scene& scene, Edits& edits);
/// Height in window coordinates; 0: no comparison.
float compare_bar_height(const Scene& scene);
