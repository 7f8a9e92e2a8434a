// Tone mapping: linear light without an upper end into 0..1, still linear. Once a picture, at the end.
#ifndef AFTERGLOW_TONEMAP
#define AFTERGLOW_TONEMAP

#include "color.glsl"

const int tone_map_clamp = 0;
const int tone_map_reinhard = 1;
const int tone_map_aces = 2;

// Reinhard et al., "Photographic Tone Reproduction for Digital Images", SIGGRAPH 2002, equation 3.
vec3 reinhard(vec3 light) {
    return light / (1.0 + light);
}

// The same paper, equation 4: light of `white` becomes exactly 1.
vec3 reinhard_to_white(vec3 light, float white) {
    return light * (1.0 + light / (white * white)) / (1.0 + light);
}

// K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2016: a fit by five numbers; 1 becomes 0.804.
vec3 aces(vec3 light) {
    return light * (2.51 * light + 0.03) / (light * (2.43 * light + 0.59) + 0.14);
}

// Each channel by itself: bright colours turn white, as in a camera. `white` is Reinhard's; 0: none.
vec3 tone_mapped(vec3 light, int curve, float white) {
    vec3 mapped = light;
    if (curve == tone_map_reinhard)
        mapped = white > 0.0 ? reinhard_to_white(light, white) : reinhard(light);
    else if (curve == tone_map_aces)
        mapped = aces(light);
    return clamp(mapped, 0.0, 1.0);
}

// The brightest channel sets the scale of all three: the hue stays however bright it gets.
vec3 tone_mapped_keeping_hue(vec3 light, int curve, float white) {
    float brightest = brightest_channel(light);
    if (brightest <= 0.0)
        return vec3(0.0);
    return light * (tone_mapped(vec3(brightest), curve, white).r / brightest);
}

#endif
