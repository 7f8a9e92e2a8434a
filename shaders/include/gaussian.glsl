// Gaussians over pixels: not sampled at the pixel's centre, but integrated over its area.
#ifndef AFTERGLOW_GAUSSIAN
#define AFTERGLOW_GAUSSIAN

#include "erf.glsl"

const float gaussian_pi = 3.14159265359;

// What falls on a pixel (1 x 1) of exp(-sharpness |r|^2), its middle `offset` px from the pixel's.
// A Gaussian is separable, so the integral is one of x times one of y; over all pixels the sum is
// pi / sharpness wherever the middle lies.
float gaussian_over_pixel(vec2 offset, float sharpness) {
    float root = sqrt(sharpness);
    vec2 sides = erf(root * (offset + 0.5)) - erf(root * (offset - 0.5));
    return gaussian_pi / (4.0 * sharpness) * sides.x * sides.y;
}

#endif
