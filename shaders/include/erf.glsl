// The error function and related functions, for sums of Gaussians.
#ifndef AFTERGLOW_ERF
#define AFTERGLOW_ERF

// erf by Abramowitz and Stegun, 7.1.28. The error is at most 3e-7, and about 1e-6 with the rounding
// of 32-bit floats.
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

float erf(float x) {
    return erf(vec2(x)).x;
}

// exp(x x) (1 - erf(x)) for x >= 0. It is 1 at 0 and falls slowly, where its factors are too large
// and too small for a float. A minimax fit of its logarithm minus that of t, over
// t = 1 / (1 + x/2). The relative error is at most 5e-7.
vec2 erfcx(vec2 x) {
    vec2 t = 1.0 / (1.0 + 0.5 * x);
    vec2 power = -1.265512311 + t * (1.000037772 + t * (0.3737148406 + t * (0.1006541982 +
                 t * (-0.2061395608 + t * (0.3360064746 + t * (-1.231761466 + t * (1.583596734 +
                 t * (-0.8726416532 + t * 0.1820451054))))))));
    return t * exp(power);
}

#endif
