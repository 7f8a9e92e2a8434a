#pragma once

#include "model/look/picture.h"

/// How many pixels along both sides show one pixel of the original, where a picture was enlarged by
/// a whole number with nearest-neighbour sampling: 2 to 8. 1 for any other picture, and for one
/// that changes at fewer than eight columns or rows, which tells too little.
int found_prescale(const Picture& picture);

/// The original of a picture that shows each pixel as `times` x `times` pixels, at least 1 x 1: the
/// middle one of each. What is left over at the right and at the bottom is cut off.
Picture without_prescale(const Picture& picture, int times);

/// The size of what without_prescale() makes.
Extent extent_without_prescale(Extent extent, int times);
