#version 410 core
#include "beam_segment.glsl"

uniform vec2 u_resolution;
uniform float sigma = 1.2;  // @range 0.1 20
uniform float rate = 0.0;   // @range 0 1e6

in vec4 segment;
in vec2 intensities;
in vec2 ages_seconds;

flat out vec4 ends;     // px
flat out vec2 charges;  // faded as much as the end's light
flat out float fade;

void main() {
    ends = (0.5 + 0.5 * segment) * u_resolution.xyxy;
    charges = intensities * exp(-rate * ages_seconds.y);
    fade = rate * (ages_seconds.x - ages_seconds.y);
    vec2 corner =
        beam_segment_corner(ends.xy, ends.zw, beam_segment_reach(sigma), gl_VertexID);
    gl_Position = vec4(2.0 * corner / u_resolution - 1.0, 0.0, 1.0);
}
