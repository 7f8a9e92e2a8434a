#version 410 core
// Bloom pyramid, down: the light at half the size. Linear light.
#include "bloom_width.glsl"
#include "pyramid.glsl"

uniform sampler2D larger;

out vec4 color;

void main() {
    color = vec4(has_pyramid() ? pyramid_reduced(larger, gl_FragCoord.xy) : vec3(0.0), 1.0);
}
