#version 410 core
// The beam as segments: the light along the path from one point to the next. It has the same form
// and energy as points. Current and age change linearly along it. Light fades inside the segment.
#include "beam_segment.glsl"
#include "decay.glsl"
#include "one_color.glsl"
#include "spot.glsl"
#include "tube.glsl"

flat in vec4 ends;
flat in vec2 charges;
flat in vec2 ages;
flat in vec2 sigmas;
flat in vec2 areas;
flat in vec4 colors;
out vec4 color;

// E-folds per second, of the custom tube's channels or of a measured tube's terms.
vec3 fade_rates() {
    return has_tube() ? 1.0 / term_seconds() : -60.0 * log(max(decay, 1e-6)) * fade_speeds();
}

// The part of a charge of 1 that is left, or for a measured tube the part that is emitted.
vec3 part_after(float seconds, vec3 rates) {
    return has_tube() ? spent_after(seconds * rates) : exp(-seconds * rates);
}

// Up to this number of e-folds in the segment, fading is linear to 3 parts in a million.
const float even_fade = 0.005;

// For one Gaussian of unit area, at one position. rgb: the three parts, alpha: the whole charge.
vec4 charge_at(vec2 place, float sigma, vec3 rates) {
    vec2 at = beam_segment_place(place, ends.xy, ends.zw);
    float segment_length = distance(ends.xy, ends.zw);
    vec2 shares = beam_segment_shares(at, segment_length, sigma, 0.0);
    vec2 lit = charges * vec2(shares.x - shares.y, shares.y);
    float whole = lit.x + lit.y;
    vec3 parts = lit.x * part_after(ages.x, rates) + lit.y * part_after(ages.y, rates);
    vec3 fades = (ages.x - ages.y) * rates;
    for (int i = 0; i < 3; ++i)
        if (fades[i] > even_fade) {
            float left = exp(-ages.y * rates[i]) *
                         beam_segment_light(at, segment_length, sigma, fades[i], charges);
            parts[i] = has_tube() ? whole - left : left;
        }
    return vec4(parts, whole);
}

vec4 charge_over_pixel(float sigma, vec3 rates) {
    int n = beam_segment_readings(sigma);
    vec4 sum = vec4(0.0);
    int y = 0;
    do {
        int x = 0;
        do {
            vec2 reading = beam_segment_reading(ivec2(x, y), n);
            sum += charge_at(gl_FragCoord.xy + reading, sigma, rates);
            ++x;
        } while (x < n);
        ++y;
    } while (y < n);
    return sum / float(n * n);
}

void main() {
    vec3 rates = fade_rates();
    vec4 brightness;
    if (glow_weight > 0.0 && sigmas.x != sigmas.y)
        brightness = areas.x * charge_over_pixel(sigmas.x, rates) +
                     areas.y * charge_over_pixel(sigmas.y, rates);
    else
        brightness = (areas.x + areas.y) * charge_over_pixel(sigmas.x, rates);
    brightness *= beam_gain * colors;
    vec3 shade = has_one_color() ? vec3(1.0) : beam_color;
    color = has_tube() ? brightness : vec4(shade * brightness.rgb, 1.0);
}
