// The light of a beam that moves along a line at an even speed. Linear light, lengths in px.
//
// The spot is a Gaussian of unit area. What a segment leaves is such a Gaussian across it, times an
// integral along it over s, 0 at its start and 1 at its end:
//   charge(s) exp(-fade (1 - s)) g(along - s length),   g: the Gaussian of unit area in one dimension.
// `charge` goes evenly from charges.x to charges.y; `fade` is by how many e-folds the start's light has
// faded more than the end's. Over all pixels this adds up to what is left of the mean charge, for any
// length, width and direction.
//
// Without decay the integral is a difference of two erf, as woscope draws it (github.com/m1el/woscope);
// with decay it is equation (1) of "Simulating an XY oscilloscope on the GPU", whose factors are here
// put together before they can overflow.
#ifndef AFTERGLOW_BEAM_SEGMENT
#define AFTERGLOW_BEAM_SEGMENT

#include "erf.glsl"

const float beam_root_pi = 1.77245385091;

// How far from the segment light is drawn, px: five sigmas, where a spot has fallen to 4e-6, and half
// a pixel's diagonal.
float beam_segment_reach(float sigma) {
    return 5.0 * sigma + 0.71;
}

// Where corner 0..3 of a segment's quad (a strip of two triangles) lies, px.
vec2 beam_segment_corner(vec2 start, vec2 end, float reach, int corner) {
    vec2 way = end - start;
    vec2 ahead = length(way) > 0.0 ? normalize(way) : vec2(1.0, 0.0);
    vec2 left = vec2(-ahead.y, ahead.x);
    vec2 from = (corner & 1) == 0 ? start - reach * ahead : end + reach * ahead;
    return from + ((corner & 2) == 0 ? -reach : reach) * left;
}

// What a beam at rest keeps of its light while the start fades: its share, and the mean s of it.
vec2 beam_rest_moments(float fade) {
    float kept = fade < 0.01 ? 1.0 - fade * (0.5 - fade / 6.0) : (1.0 - exp(-fade)) / fade;
    float middle = fade < 0.1 ? 0.5 + fade * (1.0 / 12.0 - fade * fade / 720.0)
                              : 1.0 / (1.0 - exp(-fade)) - 1.0 / fade;
    return vec2(kept, middle);
}

// Both functions: the integral along the segment for a charge of 1 and for a charge of s. `start` and
// `end` are how far this place lies past either, in sqrt(2) sigmas.

// Gauss and Legendre's rule with five nodes: no difference of near numbers, so good for the shortest
// segment.
vec2 beam_moments_by_quadrature(float start, float end, float fade) {
    const float nodes[5] = float[5](0.0469100770, 0.2307653449, 0.5, 0.7692346551, 0.9530899230);
    const float weights[5] =
        float[5](0.1184634425, 0.2393143352, 0.2844444444, 0.2393143352, 0.1184634425);
    vec2 sum = vec2(0.0);
    for (int i = 0; i < 5; ++i) {
        float place = mix(start, end, nodes[i]);
        float light = weights[i] * exp(-place * place - fade * (1.0 - nodes[i]));
        sum += light * vec2(1.0, nodes[i]);
    }
    return sum / beam_root_pi;
}

vec2 beam_moments_by_erf(float start, float end, float fade) {
    float span = start - end;
    float shift = 0.5 * fade / span;
    vec2 sides = vec2(start, end) + shift;
    // exp(end-side^2 - end^2) (erf(start side) - erf(end side)), with erfcx where both are on one side.
    vec2 fallen = exp(-vec2(start * start + fade, end * end));
    float difference;
    if (sides.y >= 0.0) {
        vec2 rest = fallen * erfcx(sides);
        difference = rest.y - rest.x;
    } else if (sides.x <= 0.0) {
        vec2 rest = fallen * erfcx(-sides);
        difference = rest.x - rest.y;
    } else {
        vec2 both = erf(sides);
        difference = exp(shift * (sides.y + end)) * (both.x - both.y);
    }
    float whole = max(0.5 * difference / span, 0.0);
    float slope = span <= 1.0 ? beam_rest_moments(fade).y * whole
                              : (sides.x * whole +
                                 0.5 * (fallen.x - fallen.y) / (span * beam_root_pi)) / span;
    return vec2(whole, clamp(slope, 0.0, whole));
}

// By whichever way is exact here.
vec2 beam_segment_moments(float start, float end, float fade) {
    float span = start - end;
    if (span < 1e-3) {
        vec2 rest = beam_rest_moments(fade);
        float place = mix(start, end, rest.y);
        return rest.x * exp(-place * place) / beam_root_pi * vec2(1.0, rest.y);
    }
    if (span <= 1.0 && fade <= 2.0)
        return beam_moments_by_quadrature(start, end, fade);
    return beam_moments_by_erf(start, end, fade);
}

// Light per px^2 at a place `at.x` px along the segment from its start and `at.y` px beside it: for a
// charge of 1 all the way, and for one that goes from 0 to 1.
vec2 beam_segment_shares(vec2 at, float segment_length, float sigma, float fade) {
    float scale = inversesqrt(2.0) / sigma;
    vec2 moments = beam_segment_moments(scale * at.x, scale * (at.x - segment_length), fade);
    float across = scale * at.y;
    return moments * (scale * scale * exp(-across * across) / beam_root_pi);
}

// The same for a charge that goes from charges.x to charges.y.
float beam_segment_light(vec2 at, float segment_length, float sigma, float fade, vec2 charges) {
    vec2 shares = beam_segment_shares(at, segment_length, sigma, fade);
    return charges.x * shares.x + (charges.y - charges.x) * shares.y;
}

// The same of an even charge of 1: with its fading, and without. Where little fades inside the segment
// both come from one integral: exp(-fade (1 - s)) is 1 - fade + fade s, off by at most 5e-7.
vec2 beam_segment_left_and_whole(vec2 at, float segment_length, float sigma, float fade) {
    float scale = inversesqrt(2.0) / sigma;
    vec2 ends = scale * vec2(at.x, at.x - segment_length);
    vec2 moments = beam_segment_moments(ends.x, ends.y, 0.0);
    float left = fade < 1e-3 ? moments.x - fade * (moments.x - moments.y)
                             : beam_segment_moments(ends.x, ends.y, fade).x;
    float across = scale * at.y;
    return vec2(left, moments.x) * scale * scale * exp(-across * across) / beam_root_pi;
}

// How many readings on each side of a pixel its mean needs: with spots narrower than 3/4 px the sum
// over all pixels would depend on where between them the beam runs.
int beam_segment_readings(float sigma) {
    return clamp(int(ceil(0.75 / sigma)), 1, 16);
}

// From a pixel's middle to reading (i, j) of n on each side, px.
vec2 beam_segment_reading(int i, int j, int n) {
    return (vec2(i, j) + 0.5) / float(n) - 0.5;
}

// From px of the picture to px along and beside a segment.
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
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            vec2 at = beam_segment_place(middle + beam_segment_reading(i, j, n), start, end);
            sum += beam_segment_light(at, segment_length, sigma, fade, charges);
        }
    return sum / float(n * n);
}

#endif
