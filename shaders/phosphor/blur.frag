#version 410 core
// Bloom, one direction: a Gaussian of a stated sigma, at the size of its image. Linear light.
// Each texel counts on its own, so nothing is left out between the taps, and the weights add up to 1:
// light that stays inside the picture keeps its energy.
#include "as_written.glsl"
#include "blur.glsl"
#include "reference_height.glsl"

uniform sampler2D image;
uniform vec2 direction;  // (1, 0) or (0, 1)
uniform vec2 u_resolution;
uniform float bloom_radius = 3.0;  // @range 0.5 12  @limit 0.05 64  @label "Radius"  @unit "half-size px at 512 lines"  @group "Bloom"
                                   // @help "How far the light spreads: the distance between two taps of the blur, in pixels of the half-size picture."
uniform float bloom_sigma = 1.64;  // @range 0.5 4  @limit 0.1 16  @label "Sigma"  @unit "taps"  @group "Bloom"
                                   // @help "Standard deviation of the blur, in taps. Together with the radius it says how wide the bloom is: sigma x radius x 2 pixels of a picture 512 pixels high."
uniform int bloom_taps = 13;       // @range 3 25 2  @limit 1 65  @label "Taps"  @group "Bloom"
                                   // @help "Where the blur ends: this many taps across, half of them on each side. Fewer than four sigmas on each side cut the Gaussian short and are faster."

in vec2 uv;
out vec4 color;

// The article's table is meant for readings between texels; at whole taps it has two humps, and what
// lies between the taps is skipped.
vec3 blur_as_written(vec2 texel) {
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

vec3 blur_of_stated_sigma(vec2 texel) {
    float tap = bloom_radius * u_resolution.y / (0.5 * reference_height);  // texels
    int reach = int(ceil(0.5 * float(bloom_taps - 1) * tap));
    return gaussian_blur(image, uv, texel, bloom_sigma * tap, reach, 0.0);
}

void main() {
    vec2 texel = direction / u_resolution;
    color = vec4(as_written ? blur_as_written(texel) : blur_of_stated_sigma(texel), 1.0);
}
