#version 410 core
// Bloom, one direction: a Gaussian of a stated sigma, at first at half the picture's size. Linear light.
// Each texel counts on its own, so nothing is left out between the taps, and the weights add up to 1:
// light that stays inside the picture keeps its energy.
#include "as_written.glsl"
#include "reference_height.glsl"

uniform sampler2D image;  // across: of the picture's size; up: of the target's
uniform vec2 direction;   // (1, 0) or (0, 1)
uniform vec2 u_resolution;
uniform float bloom_radius = 3.0;  // @range 0.5 12  @limit 0.05 64  @label "Radius"  @unit "half-size px at 512 lines"  @group "Bloom"
                                   // @help "How far the light spreads: the distance between two taps of the blur, in pixels of the half-size picture."
uniform float bloom_sigma = 1.64;  // @range 0.5 4  @limit 0.1 16  @label "Sigma"  @unit "taps"  @group "Bloom"
                                   // @help "Standard deviation of the blur, in taps. Together with the radius it says how wide the bloom is: sigma x radius x 2 pixels of a picture 512 pixels high."
uniform int bloom_taps = 13;       // @range 3 25 2  @limit 1 65  @label "Taps"  @group "Bloom"
                                   // @help "Where the blur ends: this many taps across, half of them on each side. Fewer than four sigmas on each side cut the Gaussian short and are faster."
uniform float bloom_size = 0.5;    // @range 0.25 1  @limit 0.0625 1  @label "Resolution"  @unit "of the picture"  @group "Bloom"
                                   // @help "Size of the picture that is blurred. The glow is as wide at any size; a smaller one is softer and faster. 0.5 is the article's."

in vec2 uv;
out vec4 color;

// The light of a texel of the target: all of the picture's that lie in it. A reading between four
// texels averages them.
vec4 reading(vec2 at) {
    int n = direction.x > 0.0 ? max(int(round(0.5 / bloom_size)), 1) : 1;
    if (n == 1)
        return texture(image, at);
    vec2 apart = 1.0 / (float(n) * u_resolution);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            sum += texture(image, at + (vec2(i, j) - 0.5 * float(n - 1)) * apart);
    return sum / float(n * n);
}

// Neighbouring values of the Gaussian follow from each other by multiplication: K. Turkowski,
// "Incremental Computation of the Gaussian", GPU Gems 3, chapter 40.
vec4 gaussian_blur(vec2 texel) {
    float tap = bloom_radius * u_resolution.y / (0.5 * reference_height);  // texels
    int reach = int(ceil(0.5 * float(bloom_taps - 1) * tap));
    float fall = exp(-0.5 / (bloom_sigma * bloom_sigma * tap * tap));
    vec3 weight = vec3(1.0, fall, fall * fall);

    vec4 sum = reading(uv);
    float total = 1.0;
    for (int i = 1; i <= reach; ++i) {
        weight.xy *= weight.yz;
        vec2 offset = float(i) * texel;
        sum += weight.x * (reading(uv + offset) + reading(uv - offset));
        total += 2.0 * weight.x;
    }
    return sum / total;
}

// The article's table is meant for readings between texels; at whole taps it has two humps, and what
// lies between the taps is skipped.
vec4 blur_as_written(vec2 texel) {
    const float weights[7] = float[7](0.19648255, 0.29690696, 0.21959561, 0.04393693, 0.01096343,
                                      0.00183638, 0.00021493);
    vec4 sum = vec4(0.0);
    float total = 0.0;
    for (int i = -6; i <= 6; ++i) {
        sum += weights[abs(i)] * texture(image, uv + float(i) * bloom_radius * texel);
        total += weights[abs(i)];
    }
    return sum / total;
}

void main() {
    vec2 texel = direction / u_resolution;
    color = as_written ? blur_as_written(texel) : gaussian_blur(texel);
}
