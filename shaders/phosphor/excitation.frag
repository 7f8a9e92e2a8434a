#version 410 core
// Excitation: the charge that each of a measured tube's three terms holds at the end of the frame,
// in red, green and blue. 32-bit floats, as in persistence. A single texel while the tube is
// custom.
#include "ceiling.glsl"
#include "fresh.glsl"
#include "tube.glsl"

uniform sampler2D previous;  // this pass in the previous frame
uniform float u_time_delta;

in vec2 uv;
out vec4 color;

// The charge at which each term alone is as bright as the ceiling for 1/60 s, at any frame rate.
vec3 most_charge() {
    vec3 brightness = frame_brightness(1.0 / 60.0) * term_light() *
                      spent_after(1.0 / (60.0 * term_seconds()));
    return ceiling / max(brightness, 1e-20);
}

void main() {
    if (!has_tube()) {
        color = vec4(0.0);
        return;
    }
    vec4 fresh = fresh_at(uv, u_time_delta);  // the emitted part of the charge; alpha: all of it
    vec3 kept = texture(previous, uv).rgb * exp(-u_time_delta / term_seconds());
    color = vec4(min(kept + max(fresh.a - fresh.rgb, 0.0), most_charge()), 1.0);
}
