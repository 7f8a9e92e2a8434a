#version 410 core
// Bloom pyramid, up: back to twice the size. Linear light.
#include "bloom_size.glsl"
#include "bloom_width.glsl"
#include "pyramid.glsl"

uniform sampler2D own;      // of this size, on the way down
uniform sampler2D smaller;  // next smaller level, on the way up
uniform int level;
uniform vec2 u_output_resolution;

out vec4 color;

void main() {
    float height = floor(u_output_resolution.y * bloom_size + 0.5);  // of the largest level
    float share = pyramid_share(level, bloom_variance(height));
    color = vec4(pyramid_widened(own, smaller, gl_FragCoord.xy, share), 1.0);
}
