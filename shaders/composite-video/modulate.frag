#version 410 core
// Modulate: luma in red, chroma on its subcarrier in green.
#include "signal_settings.glsl"

uniform sampler2D components;

uniform float chroma_bandwidth = 1.3;  // @range 0.4 3  @limit 0.1 6  @label "Chroma bandwidth"  @unit "MHz"  @group "Signal"  @when connection != "RGB"
                                       // @help "Frequency at which the encoder's filter halves the power of the colours. Both standards specify 1.3 MHz. Less smears colours along the line."

out vec4 color;

const int reach = 16;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int last = textureSize(components, 0).x - 1;
    float deviation = gaussian_for(chroma_bandwidth, standard);
    vec2 chroma = vec2(0.0);
    float total = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        float weight = gaussian_weight(i, deviation);
        chroma += weight * texelFetch(components, ivec2(clamp(at.x + i, 0, last), at.y), 0).yz;
        total += weight;
    }
    vec2 carrier = subcarrier_at(phase_of(at.y), at.x) * vec2(1.0, v_sign_of(at.y));
    float luma = texelFetch(components, at, 0).x;
    color = vec4(luma, dot(chroma / total, carrier), 0.0, 1.0);
}
