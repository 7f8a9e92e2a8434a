#version 410 core
#include "beam_segment.glsl"

uniform float sigma = 1.2;  // @range 0.1 20

flat in vec4 ends;
flat in vec2 charges;
flat in float fade;
out vec4 color;

void main() {
    color = vec4(beam_segment_over_pixel(gl_FragCoord.xy, ends.xy, ends.zw, sigma, fade, charges));
}
