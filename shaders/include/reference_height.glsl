// Lengths that shall look the same in a picture of any size are given in px of one this high.
#ifndef AFTERGLOW_REFERENCE_HEIGHT
#define AFTERGLOW_REFERENCE_HEIGHT

const float reference_height = 512.0;

#endif
