// A phosphor of one colour: its light is one number a pixel, and gets the colour where it is seen.
#ifndef PHOSPHOR_ONE_COLOR
#define PHOSPHOR_ONE_COLOR

#include "ceiling.glsl"
#include "spot.glsl"
#include "tube.glsl"

uniform bool one_color = false;  // @label "One colour"  @group "Phosphor"
                                 // @help "For the tube 'Custom': all light has the beam's colour and fades alike, so that one number is kept for each pixel instead of four. The same picture with less work; a signal's own colours and Fade by colour are left out."

bool has_one_color() {
    return one_color && !has_tube();
}

// What is kept of a light whose brightest channel ends at the ceiling; the article's channels end
// each by itself, the weakest last.
float one_color_ceiling() {
    float strongest = max(max(beam_color.r, beam_color.g), beam_color.b);
    float weakest = min(min(beam_color.r, beam_color.g), beam_color.b);
    return ceiling / max(as_written ? weakest : strongest, 1e-3);
}

// The light of a texel, whatever its ceiling.
vec3 colored(vec3 texel) {
    return has_one_color() ? beam_color * texel.r : texel;
}

vec3 light_of(vec3 texel) {
    return has_one_color() && as_written ? min(colored(texel), vec3(ceiling)) : colored(texel);
}

// What the bloom is made of: as the strongest channel has it.
vec3 bloom_light_of(vec3 texel) {
    float strongest = max(max(beam_color.r, beam_color.g), beam_color.b);
    return has_one_color() && as_written ? min(texel, vec3(ceiling / max(strongest, 1e-3))) : texel;
}

#endif
