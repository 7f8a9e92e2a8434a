#pragma once

#include "ui/edits.h"
#include "ui/scene.h"
#include "ui/strip_blocks.h"
#include "ui/widgets.h"

/// The picture of a pass in the strip with what is marked on it, at the cursor and to be clicked,
/// over `words` more height too. Where the picture is wider than the place, the part of it that is
/// seen lies from 0, its left end, to 1, its right one.
void draw_strip_cell(const StripPass& pass, const Scene& scene, const Rect& place, float words,
                     float part, Edits& edits);
