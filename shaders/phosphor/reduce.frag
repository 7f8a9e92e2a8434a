#version 410 core
// Input of the bloom: the phosphor's light at a smaller size, half by default. Linear light.

#include "bloom_size.glsl"
#include "kept_light.glsl"
#include "one_color.glsl"

uniform sampler2D image;
uniform vec2 u_resolution;

in vec2 uv;
out vec4 color;

// Mean of four texels, each limited to the ceiling first, so light above it does not spread.
// Clamped to the edge.
vec3 mean_of_four(vec2 at) {
    if (has_tube())
        return texture(image, at).rgb;
    vec2 size = vec2(textureSize(image, 0));
    vec2 place = at * size - 0.5;
    vec2 corner = clamp(floor(place), vec2(0.0), max(size - 2.0, 0.0));
    vec2 part = clamp(place - corner, vec2(0.0), min(size - 1.0, 1.0));
    if (has_one_color()) {
        vec4 four = min(textureGather(image, (corner + 1.0) / size), vec4(one_color_ceiling()));
        return vec3(mix(mix(four.w, four.z, part.x), mix(four.x, four.y, part.x), part.y), 0.0, 0.0);
    }
    ivec2 texel = ivec2(corner);
    vec3 lower = mix(kept_texel(image, texel), kept_texel(image, texel + ivec2(1, 0)), part.x);
    vec3 upper =
        mix(kept_texel(image, texel + ivec2(0, 1)), kept_texel(image, texel + 1), part.x);
    return mix(lower, upper, part.y);
}

// The light of a texel of the target: the mean over all texels of the picture within it.
vec3 mean_light(vec2 at) {
    int n = max(int(round(0.5 / bloom_size)), 1);
    vec2 apart = 1.0 / (float(n) * u_resolution);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            sum += mean_of_four(at + (vec2(i, j) - 0.5 * float(n - 1)) * apart);
    return sum / float(n * n);
}

void main() {
    color = vec4(bloom_light_of(mean_light(uv)), 1.0);
}
