// Gaussians over pixels: integrated over the pixel's area instead of sampled at its centre.
#ifndef AFTERGLOW_GAUSSIAN
#define AFTERGLOW_GAUSSIAN

#include "erf.glsl"

const float gaussian_pi = 3.14159265359;

// Integral of exp(-sharpness |r|^2) over a pixel (1 x 1), with its middle `offset` px from the
// pixel's. A Gaussian is separable, so the integral is a product of one over x and one over y. The
// sum over all pixels is pi / sharpness for any position of the middle.
float gaussian_over_pixel(vec2 offset, float sharpness) {
    float root = sqrt(sharpness);
    vec2 sides = erf(root * (offset + 0.5)) - erf(root * (offset - 0.5));
    return gaussian_pi / (4.0 * sharpness) * sides.x * sides.y;
}

#endif
