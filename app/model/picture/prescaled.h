#pragma once

#include "model/look/picture.h"

/// The integer factor, 2 to 8, by which a picture was enlarged with nearest-neighbour sampling. 1
/// for other pictures, and for pictures with changes at fewer than eight columns or rows, which are
/// not sufficient evidence.
int found_prescale(const Picture& picture);

/// The original of a picture that shows each pixel as `times` x `times` pixels: the middle pixel of
/// each block, at least 1 x 1. Remaining pixels at the right and bottom are dropped.
Picture without_prescale(const Picture& picture, int times);

/// The size of the result of without_prescale().
Extent extent_without_prescale(Extent extent, int times);
