// Tone mapping: maps linear light without an upper limit to what the display shows, still linear.
// That is 0..1, or with HDR 0..peak. Applied once per picture, at the end.
#ifndef AFTERGLOW_TONEMAP
#define AFTERGLOW_TONEMAP

#include "color.glsl"

const int tone_map_clamp = 0;
const int tone_map_reinhard = 1;
const int tone_map_aces = 2;
const int tone_map_reinhard_to_white = 3;
const int tone_map_agx = 4;
const int tone_map_neutral = 5;
const int tone_map_none = 6;

// Reinhard et al., "Photographic Tone Reproduction for Digital Images", SIGGRAPH 2002, equation 3.
vec3 reinhard(vec3 light) {
    return light / (1.0 + light);
}

// The same paper, equation 4: maps light of `white` to exactly 1.
vec3 reinhard_to_white(vec3 light, float white) {
    return light * (1.0 + light / (white * white)) / (1.0 + light);
}

// K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2016: a fit with five numbers. Maps 1 to 0.804.
vec3 aces(vec3 light) {
    return light * (2.51 * light + 0.03) / (light * (2.43 * light + 0.59) + 0.14);
}

// One side of AgX's curve, from its pivot at (10 / 16.5, 0.5) with slope 2 to 0 or to 1. `reach` is
// the length of this side in x. Its length in y is 0.5.
vec3 agx_side(vec3 away, float reach, float power) {
    const float slope = 2.0;
    float rise = pow(slope * reach / 0.5, power) - 1.0;
    float scale = slope * reach * pow(rise, -1.0 / power);
    vec3 x = slope * away / scale;
    return scale * x * pow(1.0 + pow(x, vec3(power)), vec3(-1.0 / power));
}

// AgX by T. Sobotka (github.com/sobotka/AgX). First a little of each channel is added to the
// others, so that bright colours desaturate as on film. Then a curve over 16.5 stops around 0.18 is
// applied, and the channels are separated again. Matrices for sRGB's primaries: B. Wrensch,
// "Minimal AgX Implementation", 2024.
vec3 agx(vec3 light) {
    const mat3 inset = mat3(0.842479062253094, 0.0423282422610123, 0.0423756549057051,
                            0.0784335999999992, 0.878468636469772, 0.0784336,
                            0.0792237451477643, 0.0791661274605434, 0.879142973793104);
    const mat3 outset = mat3(1.19687900512017, -0.0528968517574562, -0.0529716355144438,
                             -0.0980208811401368, 1.15190312990417, -0.0980434501171241,
                             -0.0990297440797205, -0.0989611768448433, 1.15107367264116);
    const float darkest = -12.47393;  // stops
    const float brightest = 4.026069;
    const float pivot = 10.0 / 16.5;
    vec3 stops = log2(max(inset * light, vec3(1e-10)));
    vec3 x = clamp((stops - darkest) / (brightest - darkest), 0.0, 1.0);
    vec3 toe = 0.5 - agx_side(max(pivot - x, 0.0), pivot, 3.0);
    vec3 shoulder = 0.5 + agx_side(max(x - pivot, 0.0), 1.0 - pivot, 3.25);
    vec3 shown = mix(toe, shoulder, greaterThan(x, vec3(pivot)));
    return pow(max(outset * shown, vec3(0.0)), vec3(2.2));
}

// Khronos PBR Neutral: "Khronos PBR Neutral Tone Mapper", specification of 2024. Colours up to 0.8
// are unchanged, except for the 0.04 that glass and plastic reflect. Brighter ones are compressed
// and desaturated.
vec3 khronos_neutral(vec3 light) {
    const float start = 0.8 - 0.04;
    const float desaturation = 0.15;
    float darkest = min(light.r, min(light.g, light.b));
    light -= darkest < 0.08 ? darkest - 6.25 * darkest * darkest : 0.04;
    float peak = brightest_channel(light);
    if (peak < start)
        return light;
    float room = 1.0 - start;
    float lowered = 1.0 - room * room / (peak + room - start);
    float paled = 1.0 - 1.0 / (desaturation * (peak - lowered) + 1.0);
    return mix(light * (lowered / peak), vec3(lowered), paled);
}

// The curves that map each channel separately. Bright colours turn white, as in a camera. `white`
// is the white point of Reinhard; 0 turns it off. Looks without other curves call this function:
// software GL executes every branch, so this halves the work.
vec3 tone_mapped_per_channel(vec3 light, int curve, float white) {
    vec3 mapped = light;
    if (curve == tone_map_reinhard_to_white || (curve == tone_map_reinhard && white > 0.0))
        mapped = reinhard_to_white(light, max(white, 1e-3));
    else if (curve == tone_map_reinhard)
        mapped = reinhard(light);
    else if (curve == tone_map_aces)
        mapped = aces(light);
    return clamp(mapped, 0.0, 1.0);
}

// Applies any of the curves.
vec3 tone_mapped(vec3 light, int curve, float white) {
    if (curve == tone_map_none)
        return light;
    if (curve == tone_map_agx)
        return clamp(agx(light), 0.0, 1.0);
    if (curve == tone_map_neutral)
        return clamp(khronos_neutral(light), 0.0, 1.0);
    return tone_mapped_per_channel(light, curve, white);
}

// The white point relative to a display that shows light up to `peak`. 0 stays off. What the display
// can show needs no compression.
float white_for_peak(float white, float peak) {
    return peak > 1.0 && white > 0.0 ? max(white / peak, 1.0) : white;
}

// The curves for a display that shows light up to `peak`, which is 1 without HDR.
vec3 tone_mapped_per_channel_to(vec3 light, int curve, float white, float peak) {
    return peak * tone_mapped_per_channel(light / peak, curve, white_for_peak(white, peak));
}

vec3 tone_mapped_to(vec3 light, int curve, float white, float peak) {
    return peak * tone_mapped(light / peak, curve, white_for_peak(white, peak));
}

// Scales all three channels by the same factor, so that the brightest becomes `brightest_mapped`.
// The hue is kept at any brightness.
vec3 with_brightest(vec3 light, float brightest_mapped) {
    float brightest = brightest_channel(light);
    if (brightest <= 0.0)
        return vec3(0.0);
    return light * (brightest_mapped / brightest);
}

vec3 tone_mapped_keeping_hue(vec3 light, int curve, float white) {
    return with_brightest(light, tone_mapped(vec3(brightest_channel(light)), curve, white).r);
}

vec3 tone_mapped_keeping_hue_to(vec3 light, int curve, float white, float peak) {
    float brightest = brightest_channel(light);
    return with_brightest(light, tone_mapped_to(vec3(brightest), curve, white, peak).r);
}

#endif
