#pragma once

#include "lab/inspect/texel_values.h"
#include "ui/frame/scene.h"

#include <imgui/imgui.h>

/// The size of a texel, in device pixels, that fits three numbers below each other.
Extent min_cell(const Scene& scene);

/// Draws the values of texels into their cells, over a view with top left corner `low`. Red is
/// first; alpha only if it fits. If one channel is chosen, only that one.
void draw_cell_texts(const TexelValues& cells, const ImVec2& low, const ImVec2& size,
                     const Scene& scene);
