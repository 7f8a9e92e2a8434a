#pragma once

#include "lab/inspect/cell_numbers.h"
#include "ui/frame/scene.h"

#include <imgui/imgui.h>

/// Device pixels that a texel needs for three numbers below each other.
Extent least_cell(const Scene& scene);

/// Writes the numbers of texels into them, over a view whose top left corner is `low`: red first,
/// alpha where there is room for it; of a chosen channel that one alone.
void draw_cell_texts(const CellNumbers& cells, const ImVec2& low, const ImVec2& size,
                     const Scene& scene);
