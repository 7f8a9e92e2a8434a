// How the phosphor of the custom tube fades. Linear light.
#ifndef PHOSPHOR_DECAY
#define PHOSPHOR_DECAY

#include "one_color.glsl"

uniform float decay = 0.92;  // @range 0.5 0.999  @limit 0 1  @label "Decay"  @unit "per 1/60 s"  @group "Phosphor"
                             // @help "How much of the light is left a sixtieth of a second later. 0.5 is gone at once, 0.92 leaves a short tail, 0.99 glows for seconds. For the tube 'Custom'; the others fade as they were measured."
uniform vec3 fade_speed = vec3(1.0);  // @range 0.25 16  @limit 0 1000  @scale log  @label "Fade by colour"  @parts "Red" "Green" "Blue"  @group "Phosphor"
                                      // @help "1 fades as Decay says, 4 is four times as fast. Blue that fades before green leaves a yellow-green afterglow, as the two layers of a radar tube do. For the tube 'Custom'."

vec3 fade_speeds() {
    return has_one_color() ? vec3(1.0) : fade_speed;
}

// What is left of a light of 1 after some seconds, whatever the frame rate.
vec3 left_after(float seconds) {
    return pow(vec3(max(decay, 1e-6)), 60.0 * seconds * fade_speeds());
}

#endif
