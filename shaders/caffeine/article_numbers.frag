#version 410 core
// The article's first two textures of random numbers, drawn once when Original article is on. Red
// and green are two uniform numbers. Blue and alpha are a point on the unit circle.
#include "noise.glsl"

out vec4 color;

void main() {
    vec3 numbers = noise(uvec2(gl_FragCoord.xy), 1u);
    float around = 6.28318530718 * numbers.z;
    color = vec4(numbers.xy, cos(around), sin(around));
}
