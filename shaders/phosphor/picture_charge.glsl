// The charge that a source picture leaves on the phosphor. The picture shines evenly during the
// whole frame. Linear light.
#include "decay.glsl"
#include "one_color.glsl"
#include "tube.glsl"

uniform sampler2D picture;  // its light, or with a monochrome phosphor its luminance in red
uniform float picture_gain = 1.0;  // @range 0.05 8  @limit 0 1000  @scale log  @label "Picture gain"  @group "Beam"
                                   // @help "Light of a white picture that doesn't change. The phosphor's decay doesn't change it. Moving parts are dimmer on a slow phosphor and leave a trail."

// The part of an even excitation that is emitted when it ends, after x time constants:
// 1 - (1 - e^-x) / x.
vec3 spent_evenly(vec3 x) {
    vec3 series = x / 2.0 * (1.0 - x / 3.0 * (1.0 - x / 4.0 * (1.0 - x / 5.0)));
    return mix(1.0 - spent_after(x) / max(x, 1e-20), series, lessThan(x, vec3(0.1)));
}

// As the beam's. A measured tube: the emitted parts, and in alpha the whole charge. It emits as
// much as it gets, so a steady picture of 1 is as bright as the gain. The custom tube: the light at
// the end of the frame, g (1 - d) for a decay of d in the frame, so that g remains after many.
vec4 fresh_at(vec2 at, float frame_seconds) {
    vec3 light = picture_gain * texture(picture, at).rgb;
    if (has_tube()) {
        float charge = light.r / frame_brightness(frame_seconds);
        return charge * vec4(spent_evenly(frame_seconds / term_seconds()), 1.0);
    }
    vec3 shade = has_one_color() ? vec3(1.0) : beam_color;
    vec3 lit = as_written ? vec3(1.0 - decay) : 1.0 - left_after(frame_seconds);
    return vec4(shade * light * lit, 1.0);
}
