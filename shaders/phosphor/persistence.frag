#version 410 core
// Persistence: the phosphor's light. Linear, no upper end but the ceiling.
// Custom: what glowed a frame ago, faded, and what the beam adds now; 32-bit floats, as half floats
// stop fading at slow decays. A measured tube: the mean light of the frame, from what it held
// before and from what the beam brought.
#include "as_written.glsl"
#include "ceiling.glsl"
#include "color.glsl"
#include "decay.glsl"
#include "fresh.glsl"
#include "one_color.glsl"
#include "tone_map_every_frame.glsl"
#include "tonemap.glsl"
#include "tube_color.glsl"

uniform sampler2D previous;  // this pass, a frame ago
uniform sampler2D held;      // the charge that a measured tube held a frame ago
uniform float u_time_delta;

in vec2 uv;
out vec4 color;

// The brightest channel reaches the ceiling and takes the others along: the hue stays.
vec3 saturated(vec3 light, float most) {
    return light * min(1.0, most / max(brightest_channel(light), 1e-20));
}

vec3 custom_light() {
    vec3 kept = texture(previous, uv).rgb;
    vec3 fresh = fresh_at(uv).rgb;  // faded to the frame's end
    float most = has_one_color() ? one_color_ceiling() : ceiling;
    return as_written ? min(kept * decay + fresh, vec3(most))
                      : saturated(kept * left_after(u_time_delta) + fresh, most);
}

// Conserves: what a term held and was given is held on or is light. In frames shorter than 1/60 s a
// flash is brighter, as its light falls into less time, and so is the ceiling.
vec3 tube_light() {
    vec3 spent = spent_after(u_time_delta / term_seconds());
    vec3 given_off = spent * texture(held, uv).rgb + fresh_at(uv).rgb;
    vec3 light = term_colors() * (term_light() * given_off) * frame_brightness(u_time_delta);
    return saturated(light, ceiling * max(1.0, 1.0 / (60.0 * u_time_delta)));
}

void main() {
    vec3 light;
    if (has_tube())
        light = tube_light();
    else
        light = custom_light();
    color = vec4(tone_map_every_frame ? reinhard(light) : light, 1.0);
}
