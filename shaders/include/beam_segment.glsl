// The light of a beam that moves along a line at constant speed. Linear light, lengths in px.
//
// The spot is a Gaussian of unit area. The light of a segment is such a Gaussian across it, times
// an integral along it over s, which is 0 at its start and 1 at its end:
//   charge(s) exp(-fade (1 - s)) g(along - s length)
// with the Gaussian g of unit area in one dimension.
// `charge` changes linearly from charges.x to charges.y. `fade` is the number of e-folds by which
// the start has faded more than the end. The sum over all pixels is the remaining mean charge, for
// any length, width and direction.
//
// Without decay, the integral is a difference of two erf, as in woscope (github.com/m1el/woscope).
// With decay, it is equation (1) of "Simulating an XY oscilloscope on the GPU". Its factors are
// combined here before they can overflow.
#ifndef AFTERGLOW_BEAM_SEGMENT
#define AFTERGLOW_BEAM_SEGMENT

#include "erf.glsl"

const float beam_root_pi = 1.77245385091;

// Distance from the segment up to which light is drawn, px: five sigmas, where a spot has fallen to
// 4e-6, plus half a pixel's diagonal.
float beam_segment_reach(float sigma) {
    return 5.0 * sigma + 0.71;
}

// Position of corner 0..3 of a segment's quad (a strip of two triangles), px.
vec2 beam_segment_corner(vec2 start, vec2 end, float reach, int corner) {
    vec2 way = end - start;
    vec2 ahead = length(way) > 0.0 ? normalize(way) : vec2(1.0, 0.0);
    vec2 left = vec2(-ahead.y, ahead.x);
    vec2 from = (corner & 1) == 0 ? start - reach * ahead : end + reach * ahead;
    return from + ((corner & 2) == 0 ? -reach : reach) * left;
}

// The beam_moments functions return the integral along the segment, for a charge of 1 and for a
// charge of s. `start` and `end` are the distances of this position past the start and past the
// end, in sqrt(2) sigmas.

// Gauss-Legendre quadrature with three nodes. It has no difference of nearly equal numbers, so it
// is accurate for the shortest segment. For half a sqrt(2) sigma and half an e-fold, its remainder
// is below 5e-6 of the peak.
vec2 beam_moments_by_quadrature(float start, float end, float fade) {
    const vec3 nodes = vec3(0.1127016654, 0.5, 0.8872983346);
    const vec3 weights = vec3(5.0, 8.0, 5.0) / 18.0;
    vec3 place = start + (end - start) * nodes;
    vec3 light = weights * exp(-place * place - fade * (1.0 - nodes));
    return vec2(dot(light, vec3(1.0)), dot(light, nodes)) / beam_root_pi;
}

vec2 beam_moments_without_fade(float start, float end) {
    float span = start - end;
    vec2 both = erf(vec2(start, end));
    float whole = 0.5 * (both.x - both.y) / span;
    float ends = 0.5 * (exp(-start * start) - exp(-end * end)) / (span * beam_root_pi);
    return vec2(whole, (start * whole + ends) / span);
}

// The mean s of the light that is left of a stationary beam, weighted by exp(-fade (1 - s)).
float beam_rest_middle(float fade) {
    return fade < 0.1 ? 0.5 + fade * (1.0 / 12.0 - fade * fade / 720.0)
                      : 1.0 / (1.0 - exp(-fade)) - 1.0 / fade;
}

// exp(sides.y^2 - end^2) (erf(sides.x) - erf(sides.y)), computed with erfcx. If both sides have the
// same sign, it is the difference of the two tails 1 - erf.
vec2 beam_moments_with_fade(float start, float end, float fade) {
    float span = max(start - end, 1e-6);  // below this, the beam is stationary
    float shift = 0.5 * fade / span;
    vec2 sides = vec2(start, end) + shift;
    vec2 fallen = exp(-vec2(start * start + fade, end * end));
    vec2 beyond = fallen * erfcx(abs(sides));
    beyond = mix(-beyond, beyond, greaterThanEqual(sides, vec2(0.0)));
    float between = sides.x >= 0.0 && sides.y < 0.0 ? 2.0 * exp(shift * (sides.y + end)) : 0.0;
    float whole = max(0.5 * (between + beyond.y - beyond.x) / span, 0.0);
    float slope = span <= 0.25 ? beam_rest_middle(fade) * whole
                               : (sides.x * whole +
                                  0.5 * (fallen.x - fallen.y) / (span * beam_root_pi)) / span;
    return vec2(whole, clamp(slope, 0.0, whole));
}

// Chooses the accurate method for these arguments.
vec2 beam_segment_moments(float start, float end, float fade) {
    if (start - end <= 0.5 && fade <= 0.5)
        return beam_moments_by_quadrature(start, end, fade);
    if (fade == 0.0)
        return beam_moments_without_fade(start, end);
    return beam_moments_with_fade(start, end, fade);
}

// Light per px^2 at a position, `at.x` px along the segment from its start and `at.y` px across it.
// x: for a constant charge of 1. y: for a charge from 0 to 1.
vec2 beam_segment_shares(vec2 at, float segment_length, float sigma, float fade) {
    float scale = inversesqrt(2.0) / sigma;
    vec2 moments = beam_segment_moments(scale * at.x, scale * (at.x - segment_length), fade);
    float across = scale * at.y;
    return moments * (scale * scale * exp(-across * across) / beam_root_pi);
}

// The same for a charge from charges.x to charges.y.
float beam_segment_light(vec2 at, float segment_length, float sigma, float fade, vec2 charges) {
    vec2 shares = beam_segment_shares(at, segment_length, sigma, fade);
    return charges.x * shares.x + (charges.y - charges.x) * shares.y;
}

// Number of samples along each side of a pixel that its mean needs. With one sample and spots
// narrower than 3/4 px, the sum over all pixels would depend on the beam's position between them.
int beam_segment_readings(float sigma) {
    return clamp(int(ceil(0.75 / sigma)), 1, 16);
}

// Offset of one of n * n samples from the pixel's centre, px. Use do loops for the samples, because
// software GL evaluates the code after a loop's first condition once too often.
vec2 beam_segment_reading(ivec2 reading, int n) {
    return (vec2(reading) + 0.5) / float(n) - 0.5;
}


// Converts px of the picture to px along and across a segment.
vec2 beam_segment_place(vec2 place, vec2 start, vec2 end) {
    vec2 way = end - start;
    vec2 ahead = length(way) > 0.0 ? normalize(way) : vec2(1.0, 0.0);
    vec2 from_start = place - start;
    return vec2(dot(from_start, ahead), dot(from_start, vec2(-ahead.y, ahead.x)));
}

// The mean light per px^2 of the pixel around `middle`, px.
float beam_segment_over_pixel(vec2 middle, vec2 start, vec2 end, float sigma, float fade,
                              vec2 charges) {
    int n = beam_segment_readings(sigma);
    float segment_length = distance(start, end);
    float sum = 0.0;
    int y = 0;
    do {
        int x = 0;
        do {
            vec2 reading = beam_segment_reading(ivec2(x, y), n);
            vec2 at = beam_segment_place(middle + reading, start, end);
            sum += beam_segment_light(at, segment_length, sigma, fade, charges);
            ++x;
        } while (x < n);
        ++y;
    } while (y < n);
    return sum / float(n * n);
}

#endif
