// The beam's own colour at a point or on a segment. White if its signal has no colour.
#ifndef PHOSPHOR_TINT
#define PHOSPHOR_TINT

#include "one_color.glsl"
#include "tube.glsl"

in vec3 tint;

// Its effect on a charge. A measured tube always emits its own colour, with the strength of the
// strongest of the three channels.
vec4 tint_of_charge() {
    float strongest = max(tint.r, max(tint.g, tint.b));
    return has_tube() || has_one_color() ? vec4(strongest) : vec4(tint, strongest);
}

#endif
