#version 410 core
// Persistence: the phosphor's light, linear.
// Custom tube: the previous frame's light, faded, plus the light of the beam or picture, unless the beam is
// drawn onto this pass's target. The ceiling is applied on reading. 32-bit floats, because half
// floats stop fading at slow decays; see light_bits.
// Measured tube: the mean light of the frame, from the charge held before and from the beam.
#include "as_written.glsl"
#include "ceiling.glsl"
#include "decay.glsl"
#include "fresh.glsl"
#include "kept_light.glsl"
#include "one_color.glsl"
#include "tone_map_every_frame.glsl"
#include "tonemap.glsl"
#include "tube_color.glsl"

uniform sampler2D previous;  // this pass in the previous frame
uniform bool u_drawn_onto;
uniform sampler2D held;      // the charge of a measured tube in the previous frame
uniform float u_time_delta;
uniform int light_bits = 0;  // @items "32 bit" "16 bit for fast decay"  @items_was "32" "16 where it fades as truly"  @label "Light precision"  @group "Phosphor"
                             // @help "Bits per channel of the stored light. 16 bit halves the memory and the GPU work. Slow decay needs 32 bit, as 16 bit loses steps finer than 1/2048. So 16 bit applies only while the slowest channel loses at least 1/64 in 1/240 s: for Decay up to 0.939. Measured tubes always use 32 bit."

in vec2 uv;
out vec4 color;

vec3 custom_light() {
    vec3 kept = kept_texel(previous, ivec2(gl_FragCoord.xy)) *
                (as_written ? vec3(decay) : left_after(u_time_delta));
    if (u_drawn_onto)
        return kept;
    vec3 light = kept + fresh_at(uv, u_time_delta).rgb;  // new light is already faded to the end of the frame
    return tone_map_every_frame ? below_ceiling(light) : min(light, largest_half);
}

// Conserves energy: the charge of a term is either kept or emitted as light. In frames shorter than
// 1/60 s, a flash is brighter, because its light is spread over less time. The ceiling is raised
// equally.
vec3 tube_light() {
    vec3 spent = spent_after(u_time_delta / term_seconds());
    vec3 given_off = spent * texture(held, uv).rgb + fresh_at(uv, u_time_delta).rgb;
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
