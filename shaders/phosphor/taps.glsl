// The bloom's blur by taps, one direction: a Gaussian of a given sigma, at the size of its image.
// Every texel is read, so nothing is left out between the taps. The weights add up to 1, so light
// that stays inside the picture keeps its energy. Linear light.
#include "as_written.glsl"
#include "bloom_width.glsl"
#include "blur.glsl"

uniform sampler2D image;
uniform vec2 direction;  // (1, 0) or (0, 1)
uniform vec2 u_resolution;
uniform int bloom_taps = 13;       // @range 3 25 2  @limit 1 65  @label "Tap count"  @group "Bloom"  @when bloom_intensity > 0 && bloom_kind == "Taps" && !as_written
                                   // @help "Number of taps across the blur, half on each side. Fewer than four sigmas on each side cut the Gaussian short, but are faster. Only used when Blur is Taps."

// The article's table is meant for samples between texels. At whole taps it has two humps, and
// texels between the taps are skipped.
vec3 blur_as_written(vec2 uv, vec2 texel) {
    const float weights[7] = float[7](0.19648255, 0.29690696, 0.21959561, 0.04393693, 0.01096343,
                                      0.00183638, 0.00021493);
    vec3 sum = vec3(0.0);
    float total = 0.0;
    for (int i = -6; i <= 6; ++i) {
        sum += weights[abs(i)] * texture(image, uv + float(i) * bloom_radius * texel).rgb;
        total += weights[abs(i)];
    }
    return sum / total;
}

vec3 blur_of_stated_sigma(vec2 uv, vec2 texel) {
    float tap = tap_texels(u_resolution.y);
    int reach = int(ceil(0.5 * float(bloom_taps - 1) * tap));
    return gaussian_blur(image, uv, texel, bloom_sigma * tap, reach, 0.0);
}

vec3 blurred_by_taps(vec2 uv) {
    vec2 texel = direction / u_resolution;
    return as_written ? blur_as_written(uv, texel) : blur_of_stated_sigma(uv, texel);
}
