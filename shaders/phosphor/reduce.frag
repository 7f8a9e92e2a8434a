#version 410 core
// What the bloom is made of: the phosphor's light at a smaller size, at first the half. Linear light.

#include "bloom_size.glsl"
#include "kept_light.glsl"
#include "one_color.glsl"

uniform sampler2D image;
uniform vec2 u_resolution;

in vec2 uv;
out vec4 color;

// The light of a texel of the target: all of the picture's that lie in it. A reading between four
// texels averages them.
vec3 mean_light(vec2 at) {
    int n = max(int(round(0.5 / bloom_size)), 1);
    vec2 apart = 1.0 / (float(n) * u_resolution);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            sum += kept_light(image, at + (vec2(i, j) - 0.5 * float(n - 1)) * apart);
    return sum / float(n * n);
}

void main() {
    color = vec4(bloom_light_of(mean_light(uv)), 1.0);
}
