// The tube: how its phosphor stores and emits the energy of the beam. Linear light. Each of three
// terms holds a charge and emits it exponentially. A picture shows the light of its whole frame and
// not of an instant, because most of P31's is gone in 1 ms.
#ifndef PHOSPHOR_TUBE
#define PHOSPHOR_TUBE

#include "as_written.glsl"
#include "tubes.glsl"

uniform int tube = 0;  // @items "Custom" "P1" "P2" "P3" "P4" "P7" "P11" "P14" "P28" "P31" "P32"  @label "Tube phosphor"  @group "Phosphor"  @when !as_written  @photo tube
                       // @items_note "" "27 ms" "0.37 ms" "19 ms" "0.32 ms" "0.305 ms" "0.274 ms" "0.44 ms" "0.39 ms" "0.34 ms" "1 ms"
                       // @items_color "" "#00ff85" "#00ff6d" "#ffad00" "#bae5ff" "#5600ff" "#00a0ff" "#005fff" "#baff17" "#00ffa4" "#a4ff5b"
                       // @help "Phosphor of the tube. Custom fades as set by Decay, the others as measured. P1 is green, P2 blue-green, P3 amber, P4 white, P11 blue (photography). P7 is blue with a long yellow afterglow (radar). P14 is blue with an orange afterglow. P31 is green (most scopes). P28 and P32 are yellow-green with a long afterglow, P32 with the longest."
uniform float time_scale = 1.0;  // @range 0.01 1000  @limit 0.0001 100000  @scale log  @label "Decay time scale"  @unit "×"  @group "Phosphor"  @when !as_written && tube != "Custom"  @photo start 1
                                 // @help "Stretches the decay of a measured tube. At 100, one millisecond becomes a tenth of a second. The total light stays the same, spread over more time. 1 is as measured."
uniform float tail_gain = 1.0;   // @range 0 4  @limit 0 1000  @label "Afterglow gain"  @group "Phosphor"  @when !as_written && tube != "Custom"  @photo start 1
                                 // @help "Strength of a measured tube's afterglow. 1 is as measured, 0 leaves only the first flash."

bool has_tube() {
    return tube != tube_custom && !as_written;
}

// Time constants of the three terms. Only if has_tube().
vec3 term_seconds() {
    return 0.001 * time_scale * tube_milliseconds[tube - 1];
}

// The total light that each term emits for a charge of 1. As measured, their sum is 1.
vec3 term_light() {
    vec3 light = tube_weights[tube - 1] * tube_milliseconds[tube - 1];
    return light / (light.x + light.y + light.z) * vec3(1.0, tail_gain, tail_gain);
}

// Brightness of a charge of 1 in a frame in which it emits all its light. A tube of P31's luminance
// is then about as bright as the custom one at its default decay: 1 / -ln(0.92) = 12.
float frame_brightness(float frame_seconds) {
    return 12.0 / (60.0 * frame_seconds);
}

#endif
