// Decay of the custom tube's phosphor. Linear light.
#ifndef PHOSPHOR_DECAY
#define PHOSPHOR_DECAY

#include "one_color.glsl"

uniform float decay = 0.92;  // @range 0.5 0.999  @limit 0 1  @label "Decay"  @unit "per 1/60 s"  @group "Phosphor"  @when as_written || tube == "Custom"  @photo decay
                             // @help "Fraction of the light that is left after 1/60 s. 0.5 fades almost at once, 0.92 leaves a short tail, 0.99 glows for seconds, 1 never fades. Only used by the tube phosphor Custom. Measured tubes have their own decay."
uniform vec3 fade_speed = vec3(1.0);  // @range 0.25 16  @limit 0 1000  @scale log  @label "RGB decay speed"  @parts "Red" "Green" "Blue"  @group "Phosphor"  @when !as_written && tube == "Custom" && !one_color
                                      // @help "Decay speed of each channel. 1 follows Decay, 4 is four times as fast, 0 never fades. Blue that fades before green leaves a yellow-green afterglow, like the two layers of a radar tube. Only used by the tube phosphor Custom."

vec3 fade_speeds() {
    return has_one_color() ? vec3(1.0) : fade_speed;
}

// The part of a light of 1 that is left after some seconds, at any frame rate.
vec3 left_after(float seconds) {
    return pow(vec3(max(decay, 1e-6)), 60.0 * seconds * fade_speeds());
}

#endif
