#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/passes/strip_blocks.h"
#include "ui/widgets/widgets.h"

/// The picture of a pass in the strip with what is marked on it, at the cursor and to be clicked,
/// over `words` more height too. Where the picture is wider than the place, the part of it that is
/// seen lies from 0, its left end, to 1, its right one.
void draw_strip_cell(const StripPass& pass, const Scene& scene, const Rect& place, float words,
                     float part, Edits& edits);
