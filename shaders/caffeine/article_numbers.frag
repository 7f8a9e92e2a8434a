#version 410 core
// The article's textures of random numbers, drawn once while they are wanted: two even numbers in red and green, a point of
// the circle in blue and alpha.
#include "noise.glsl"

out vec4 color;

void main() {
    vec3 numbers = noise(uvec2(gl_FragCoord.xy), 1u);
    float around = 6.28318530718 * numbers.z;
    color = vec4(numbers.xy, cos(around), sin(around));
}
