// Gaussians over pixels: not sampled at the pixel's centre, but integrated over its area.
#ifndef AFTERGLOW_GAUSSIAN
#define AFTERGLOW_GAUSSIAN

const float gaussian_pi = 3.14159265359;

// The error function by Abramowitz and Stegun, 7.1.28: off by at most 3e-7, and by about 1e-6 in
// the rounding of 32-bit floats.
vec2 erf(vec2 x) {
    vec2 a = abs(x);
    vec2 sum = 1.0 + a * (0.0705230784 + a * (0.0422820123 + a * (0.0092705272 +
               a * (0.0001520143 + a * (0.0002765672 + a * 0.0000430638)))));
    vec2 power = sum * sum;
    power *= power;
    power *= power;
    power *= power;
    return sign(x) * (1.0 - 1.0 / power);
}

// What falls on a pixel (1 x 1) of exp(-sharpness |r|^2), its middle `offset` px from the pixel's.
// A Gaussian is separable, so the integral is one of x times one of y; over all pixels the sum is
// pi / sharpness wherever the middle lies.
float gaussian_over_pixel(vec2 offset, float sharpness) {
    float root = sqrt(sharpness);
    vec2 sides = erf(root * (offset + 0.5)) - erf(root * (offset - 0.5));
    return gaussian_pi / (4.0 * sharpness) * sides.x * sides.y;
}

#endif
