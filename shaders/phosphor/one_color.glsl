// A monochrome phosphor: its light is one number per pixel, coloured when it is shown.
#ifndef PHOSPHOR_ONE_COLOR
#define PHOSPHOR_ONE_COLOR

#include "ceiling.glsl"
#include "spot.glsl"
#include "tube.glsl"

uniform bool one_color = false;  // @label "Monochrome"  @group "Phosphor"  @when as_written || tube == "Custom"
                                 // @help "Stores one channel per pixel instead of four, for the same picture with less work. All light has the beam colour and fades alike. The signal's own colours and RGB decay speed are ignored. Only used by the tube phosphor Custom."

bool has_one_color() {
    return one_color && !has_tube();
}

// Limit of the stored number, at which the brightest channel reaches the ceiling. The article
// limits each channel separately, so the weakest one determines it.
float one_color_ceiling() {
    float strongest = max(max(beam_color.r, beam_color.g), beam_color.b);
    float weakest = min(min(beam_color.r, beam_color.g), beam_color.b);
    return ceiling / max(as_written ? weakest : strongest, 1e-3);
}

// The light of a texel, without a ceiling.
vec3 colored(vec3 texel) {
    return has_one_color() ? beam_color * texel.r : texel;
}

vec3 light_of(vec3 texel) {
    return has_one_color() && as_written ? min(colored(texel), vec3(ceiling)) : colored(texel);
}

// Input of the bloom, with the limit of the strongest channel.
vec3 bloom_light_of(vec3 texel) {
    float strongest = max(max(beam_color.r, beam_color.g), beam_color.b);
    return has_one_color() && as_written ? min(texel, vec3(ceiling / max(strongest, 1e-3))) : texel;
}

#endif
