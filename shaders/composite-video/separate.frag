#version 410 core
// Separate: luma in red, chroma in green. What each filter gets wrong is the picture's dots and
// false colours.
#include "signal_settings.glsl"

uniform sampler2D received;

uniform int separation = 0;       // @items "Notch" "Two-line comb" "Three-line comb"  @label "Separation"  @group "Receiver"  @when connection == "Composite" || connection == "RF"
                                  // @help "How luma and chroma are separated. A notch takes everything near the subcarrier as chroma, so fine detail becomes false colour. Combs compare lines, so detail stays, but dots hang below coloured edges."
uniform float notch_width = 1.0;  // @range 0.3 2  @limit 0.1 3.5  @label "Notch width"  @unit "MHz"  @group "Receiver"  @when connection == "Composite" || connection == "RF"
                                  // @help "Distance from the subcarrier at which the filter passes half of the power. Less leaves more detail and more crawling dots."

out vec4 color;

const int reach = 16;

// The lines whose subcarrier is opposite: the previous one of NTSC, and of PAL the one before that.
float line_difference(ivec2 at) {
    int step = row_step() * (standard == standard_pal ? 2 : 1);
    float here = texelFetch(received, at, 0).r;
    if (separation == 0 || at.y < step)
        return here;
    float before = texelFetch(received, at - ivec2(0, step), 0).r;
    if (separation == 1 || at.y + step >= int(signal_lines().z))
        return 0.5 * (here - before);
    float after = texelFetch(received, at + ivec2(0, step), 0).r;
    return 0.5 * here - 0.25 * (before + after);
}

// What is near the subcarrier: a Gaussian low pass, shifted by a quarter turn per sample. Odd samples
// have the weight 0. A second low pass is subtracted, so that nothing passes at frequency 0.
float band_at(ivec2 at) {
    float deviation = gaussian_for(notch_width, standard);
    int count = textureSize(received, 0).x;
    vec2 sums = vec2(0.0);   // of the samples: shifted and not
    vec2 gains = vec2(0.0);  // of the weights
    for (int i = -reach; i <= reach; i += 2) {
        vec2 weight = gaussian_weight(i, deviation) * vec2((i & 3) == 0 ? 1.0 : -1.0, 1.0);
        sums += weight * line_difference(ivec2(inside_line(at.x + i, count), at.y));
        gains += weight;
    }
    float leak = gains.x / gains.y;
    return (sums.x - leak * sums.y) / (gains.y * (1.0 - leak * leak));
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec2 parts = texelFetch(received, at, 0).rg;
    if (connection >= 2) {
        float chroma = band_at(at);
        parts = vec2(parts.r - chroma, chroma);
    }
    color = vec4(parts, 0.0, 1.0);
}
