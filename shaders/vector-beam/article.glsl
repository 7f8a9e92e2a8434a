// The article's fragment shader: equation (1) with its own erf, its one-dimensional profile of unit
// area and its branch for points. Lengths in px.
#ifndef VECTOR_BEAM_ARTICLE
#define VECTOR_BEAM_ARTICLE

const float root_of_2 = 1.41421356237;
const float root_of_2_pi = 2.50662827463;

// Abramowitz and Stegun, 7.1.27, without its term in a a a.
float erf_as_written(float x) {
    float a = abs(x);
    float sum = 1.0 + (0.278393 + (0.230389 + 0.078108 * a * a) * a) * a;
    float square = sum * sum;
    return sign(x) - sign(x) / (square * square);
}

// `ages` of start and end, in decay times. exp(f f) overflows at f > 9.4, as in the article.
float light_as_written(vec2 at, float segment_length, float sigma, vec2 ages) {
    float fade = ages.x - ages.y;
    if (segment_length <= 1e-5)
        return exp(-dot(at, at) / (2.0 * sigma * sigma)) / (root_of_2_pi * sigma);
    float f = fade * sigma / (root_of_2 * segment_length);
    float sides = erf_as_written(f + at.x / (root_of_2 * sigma)) -
                  erf_as_written(f + (at.x - segment_length) / (root_of_2 * sigma));
    float power = f * f - at.y * at.y / (2.0 * sigma * sigma) - ages.x + fade * at.x / segment_length;
    return sides * exp(power) / (2.0 * segment_length);
}

// The article's f = 0: light is faded from the time at which the beam was nearest to this position.
// This is correct for long segments. Beyond the ends of short ones, the beam was elsewhere at these
// times. The exponent is clamped to what a float can hold.
float decay_at_place(float along, float segment_length, float fade) {
    if (segment_length <= 1e-5)
        return 1.0;
    return exp(clamp(fade * (along / segment_length - 1.0), -80.0, 20.0));
}

#endif
