#version 410 core
// Receive: the signal after the cable, with ghosts and noise. Composite is the sum, in red. S-video
// keeps luma in red and chroma in green.
#include "noise.glsl"
#include "signal_settings.glsl"

uniform sampler2D signal;
uniform int u_frame;

uniform float noise_level = 0.0;    // @range 0 0.3  @limit 0 10  @label "Noise"  @group "Reception"  @identity 0  @when connection != "RGB"
                                    // @help "Standard deviation of the noise, where white is 1. 0.01 is a good antenna, 0.1 is snow. Noise near the subcarrier becomes coloured."
uniform float ghost = 0.0;          // @range -0.5 0.5  @limit -1 1  @label "Ghost"  @group "Reception"  @identity 0  @when connection == "RF"
                                    // @help "Strength of an echo of the signal. Below 0 it is inverted, as after a reflection."
uniform float ghost_delay = 1.5;    // @range 0.1 8  @limit 0 50  @label "Ghost delay"  @unit "us"  @group "Reception"  @when connection == "RF" && ghost != 0
                                    // @help "How much later the echo arrives. The picture is 52 us wide. 1 us is a detour of 300 m."
uniform float rf_bandwidth = 4.2;   // @range 2.5 6  @limit 2.5 7  @label "RF bandwidth"  @unit "MHz"  @group "Reception"  @when connection == "RF"
                                    // @help "Frequency at which the receiver halves the power. A channel of NTSC has 4.2 MHz, one of PAL B/G 5 MHz."

out vec4 color;

// Black before and after the line, as in its blanking.
float composite_at(int x, int y) {
    if (x < 0 || x >= textureSize(signal, 0).x)
        return 0.0;
    vec2 parts = texelFetch(signal, ivec2(x, y), 0).rg;
    return parts.r + parts.g;
}

float echoed_at(int x, int y) {
    if (ghost == 0.0)
        return composite_at(x, y);
    float delay = ghost_delay * 4.0 * subcarrier_of(standard);
    int whole = int(floor(delay));
    float part = delay - float(whole);
    return composite_at(x, y) + ghost * mix(composite_at(x - whole, y),
                                            composite_at(x - whole - 1, y), part);
}

// Three samples with the weights a, 1 - 2 a and a. The response 1 - 2 a (1 - cos w) is sqrt(1/2) at
// the bandwidth.
float filtered_at(int x, int y) {
    float angle = 6.28318530718 * rf_bandwidth / (4.0 * subcarrier_of(standard));
    float side = (1.0 - sqrt(0.5)) / (2.0 - 2.0 * cos(angle));
    return mix(echoed_at(x, y), 0.5 * (echoed_at(x - 1, y) + echoed_at(x + 1, y)), 2.0 * side);
}

// Close to a normal distribution: the sum of six uniform numbers.
vec2 noise_at(ivec2 at) {
    vec3 a = noise(uvec2(at), uint(u_frame));
    vec3 b = noise(uvec2(at), uint(u_frame) + 0x80000000u);
    vec2 sum = vec2(a.x + a.y + a.z + b.x + b.y + b.z,
                    a.x - a.y + a.z - b.x + b.y - b.z + 3.0);
    return (sum - 3.0) * 1.414213562;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec2 received = texelFetch(signal, at, 0).rg;
    if (connection == 2)
        received = vec2(received.r + received.g, 0.0);
    else if (connection == 3)
        received = vec2(filtered_at(at.x, at.y), 0.0);
    color = vec4(received + noise_level * noise_at(at), 0.0, 1.0);
}
