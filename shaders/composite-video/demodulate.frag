#version 410 core
// Demodulate: the colours of each line as display values.
#include "signal_settings.glsl"

uniform sampler2D components;
uniform sampler2D separated;

uniform float color_bandwidth = 1.3;  // @range 0.3 3  @limit 0.1 6  @label "Colour bandwidth"  @unit "MHz"  @group "Receiver"  @when connection != "RGB"
                                      // @help "Frequency at which the receiver's filter halves the power of the colours. Cheap sets have 0.5 MHz."
uniform float saturation = 1.0;       // @range 0 2  @limit 0 10  @label "Saturation"  @group "Receiver"  @identity 1  @when connection != "RGB"
                                      // @help "Strength of the colours. 0 is black and white."
uniform float hue = 0.0;              // @angle  @range -0.7854 0.7854  @limit -3.1416 3.1416  @label "Hue"  @group "Receiver"  @identity 0  @when connection != "RGB"
                                      // @help "Phase error of the subcarrier. NTSC turns all colours. PAL only loses saturation, because a delay line averages two lines."
uniform bool delay_line = true;       // @label "PAL delay line"  @group "Receiver"  @when standard == "PAL" && connection != "RGB"
                                      // @help "Averages the colours of two lines, which cancels phase errors. Off shows them as stripes, as simple sets do."

out vec4 color;

const int reach = 16;

// U and V of a line.
vec2 chroma_of(ivec2 at) {
    int count = textureSize(separated, 0).x;
    float deviation = gaussian_for(color_bandwidth, standard);
    float phase = phase_of(at.y) + hue / 6.28318530718;
    vec2 sum = vec2(0.0);
    float total = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        int x = inside_line(at.x + i, count);
        float weight = gaussian_weight(i, deviation);
        sum += weight * texelFetch(separated, ivec2(x, at.y), 0).g * subcarrier_at(phase, x);
        total += weight;
    }
    return 2.0 * sum / total * vec2(1.0, v_sign_of(at.y));
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec3 own = texelFetch(components, at, 0).rgb;
    if (connection == 0) {
        color = vec4(rgb_of(own), 1.0);
        return;
    }
    vec2 chroma = chroma_of(at);
    if (standard == standard_pal && delay_line && at.y >= row_step())
        chroma = 0.5 * (chroma + chroma_of(at - ivec2(0, row_step())));
    float luma = texelFetch(separated, at, 0).r;
    color = vec4(rgb_of(vec3(luma, saturation * chroma)), 1.0);
}
