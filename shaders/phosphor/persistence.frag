#version 410 core
// Persistence: what glowed a frame ago, faded, and what the beam adds now. Linear light, no upper end
// but the ceiling. 32-bit floats: half floats stop fading at slow decays.
#include "as_written.glsl"
#include "color.glsl"
#include "decay.glsl"
#include "tone_map_every_frame.glsl"
#include "tonemap.glsl"

uniform sampler2D current;   // the beam of this frame, faded to the frame's end
uniform sampler2D previous;  // this pass, a frame ago
uniform float u_time_delta;
uniform float ceiling = 2.5;  // @range 0.5 20  @limit 0.01 1000  @scale log  @label "Ceiling"  @group "Phosphor"
                              // @help "The brightest that the phosphor can get. A trace that stays in one place would grow without end; here it saturates."

in vec2 uv;
out vec4 color;

// The brightest channel reaches the ceiling and takes the others along: the hue stays.
vec3 saturated(vec3 light) {
    return light * min(1.0, ceiling / max(brightest_channel(light), 1e-20));
}

void main() {
    vec3 kept = texture(previous, uv).rgb;
    vec3 fresh = texture(current, uv).rgb;
    vec3 light = as_written ? min(kept * decay + fresh, vec3(ceiling))
                            : saturated(kept * left_after(u_time_delta) + fresh);
    color = vec4(tone_map_every_frame ? reinhard(light) : light, 1.0);
}
