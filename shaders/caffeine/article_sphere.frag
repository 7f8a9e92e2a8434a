#version 410 core
// The article's third texture of random numbers: points on the unit sphere. Drawn once when
// Original article is on.
#include "noise.glsl"

out vec4 color;

void main() {
    vec3 numbers = noise(uvec2(gl_FragCoord.xy), 2u);
    float around = 6.28318530718 * numbers.x;
    float z = 1.0 - 2.0 * numbers.y;
    color = vec4(sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(around), sin(around)), z, 0.0);
}
