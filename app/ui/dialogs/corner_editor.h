#pragma once

#include "lab/match/photo_matcher.h"
#include "ui/frame/edits.h"

/// The photo with its four corners, which can be dragged or moved by the arrow keys, and a
/// magnifier of the corner that was moved last. Arrow keys move by 0.1 px of the photo, with Shift
/// by 1 px.
void draw_corner_editor(const PhotoMatcher& matcher, Edits& edits);
