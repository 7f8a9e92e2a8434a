#version 410 core
// Bloom: the vertical taps, or the last step of the pyramid. Linear light.
#include "bloom_width.glsl"
#include "pyramid.glsl"
#include "taps.glsl"

uniform sampler2D own;      // of this size, on the way down
uniform sampler2D smaller;  // next smaller level of the pyramid, on the way up

in vec2 uv;
out vec4 color;

void main() {
    vec3 light;
    if (has_pyramid())
        light = pyramid_widened(own, smaller, gl_FragCoord.xy,
                                pyramid_share(0, bloom_variance(u_resolution.y)));
    else
        light = blurred_by_taps(uv);
    color = vec4(light, 1.0);
}
