#version 410 core
// Bloom: the taps upwards, or the last step of the pyramid. Linear light.
#include "bloom_width.glsl"
#include "pyramid.glsl"
#include "taps.glsl"

uniform sampler2D own;      // at this size, before it is spread
uniform sampler2D smaller;  // of the pyramid, on its way up

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
