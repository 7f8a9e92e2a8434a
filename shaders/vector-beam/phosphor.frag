#version 410 core
// The phosphor. Red: light still to be emitted. Green: light emitted during this frame. It is the
// light stored before, plus the light added by the beam, minus the light stored now. So no light is
// lost for any decay time, and its sum over time is the same at any frame rate. Blue and alpha: the
// hue of old and new light together (tint.glsl).
#include "as_written.glsl"
#include "decay.glsl"
#include "tint.glsl"

uniform sampler2D beam;    // this frame's light, see beam.frag
uniform sampler2D before;  // this pass in the previous frame
uniform float u_time_delta;

in vec2 uv;
out vec4 color;

void main() {
    vec4 fresh = texture(beam, uv);
    vec4 past = texture(before, uv);
    float kept = past.r < 1e30 ? past.r : 0.0;  // drops an overflow of the article's formula
    vec2 hue = mixed_hue(kept, past.ba, fresh.ba, as_written ? fresh.r : fresh.g);
    if (as_written) {
        // A black quad blended over it: the same fraction each frame, as if each lasted 1/60 s.
        float glowing = kept * exp(-1.0 / (60.0 * decay_seconds())) + fresh.r;
        color = vec4(glowing, glowing, hue);
        return;
    }
    float to_come = kept * exp(-u_time_delta / decay_seconds()) + fresh.r;
    float given = max(kept + fresh.g - to_come, 0.0);
    color = vec4(to_come, given, hue);
}
