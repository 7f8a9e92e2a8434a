// The tube: how its phosphor keeps and gives back what the beam leaves there. Linear light.
// Each of three terms holds the charge that it was struck with and gives it off exponentially. A
// picture shows the light of its whole frame, not of an instant: most of P31's is gone in 1 ms.
#ifndef PHOSPHOR_TUBE
#define PHOSPHOR_TUBE

#include "as_written.glsl"
#include "tubes.glsl"

uniform int tube = 0;  // @items "Custom" "P1" "P2" "P3" "P4" "P7" "P11" "P14" "P28" "P31" "P32"  @label "Tube"  @group "Phosphor"
                       // @help "The phosphor of the tube. Custom fades as Decay says. The others fade as they were measured: P1 green, P2 blue-green, P3 amber, P4 white, P7 blue with a long yellow afterglow (radar), P11 blue (photography), P14 blue with an orange afterglow, P28 yellow-green and long, P31 green (most scopes), P32 yellow-green and longest."
uniform float time_scale = 1.0;  // @range 0.01 1000  @limit 0.0001 100000  @scale log  @label "Time scale"  @unit "×"  @group "Phosphor"
                                 // @help "Stretches the fading of a measured tube: at 100 what takes a millisecond takes a tenth of a second. The light is the same in all, spread over more time."
uniform float tail_gain = 1.0;   // @range 0 4  @limit 0 1000  @label "Tail gain"  @group "Phosphor"
                                 // @help "Strength of what glows on after the first flash of a measured tube. 1 is as measured, 0 leaves the flash alone."

bool has_tube() {
    return tube != tube_custom && !as_written;
}

// Of the three terms. Only where has_tube().
vec3 term_seconds() {
    return 0.001 * time_scale * tube_milliseconds[tube - 1];
}

// The light that a charge of 1 gives in all by each term: as measured 1 together.
vec3 term_light() {
    vec3 light = tube_weights[tube - 1] * tube_milliseconds[tube - 1];
    return light / (light.x + light.y + light.z) * vec3(1.0, tail_gain, tail_gain);
}

// Brightness of a charge of 1 in a frame in which it gives off all its light. A tube of P31's
// luminance is then about as bright as the custom one at its default decay: 1 / -ln(0.92) = 12.
float frame_brightness(float frame_seconds) {
    return 12.0 / (60.0 * frame_seconds);
}

#endif
