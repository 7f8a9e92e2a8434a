#version 410 core
// Bloom by a pyramid: back to twice the size. Linear light.
#include "bloom_width.glsl"
#include "pyramid.glsl"

uniform sampler2D own;      // of this size, on the way down
uniform sampler2D smaller;  // on the way up
uniform sampler2D reduced;  // what the pyramid stands on
uniform int level;

out vec4 color;

void main() {
    float variance = bloom_variance(float(textureSize(reduced, 0).y));
    float share = pyramid_share(level, variance);
    color = vec4(pyramid_widened(own, smaller, gl_FragCoord.xy, share), 1.0);
}
