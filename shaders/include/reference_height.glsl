// Lengths that scale with the render size are given in px of a picture of this height.
#ifndef AFTERGLOW_REFERENCE_HEIGHT
#define AFTERGLOW_REFERENCE_HEIGHT

const float reference_height = 512.0;

#endif
