#version 410 core
// Bloom by taps, horizontal. Linear light.
#include "taps.glsl"

in vec2 uv;
out vec4 color;

void main() {
    color = vec4(blurred_by_taps(uv), 1.0);
}
