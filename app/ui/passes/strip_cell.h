#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/passes/strip_blocks.h"
#include "ui/widgets/widgets.h"

/// The picture of a pass with its marks, at the cursor. The clickable area extends `text_height`
/// below the picture. If the picture is wider than `rect`, `part` selects the visible part, from 0
/// at its left end to 1 at its right end.
void draw_strip_cell(const StripPass& pass, const Scene& scene, const Rect& rect, float text_height,
                     float part, Edits& edits);
