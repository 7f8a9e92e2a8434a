#version 410 core
#include "erf.glsl"

in vec2 uv;
out vec4 color;

void main() {
    float step = floor(gl_FragCoord.x);
    float x = 0.05 * step;
    color = vec4(erf(x), erf(-x), erfcx(vec2(x, exp2(step - 20.0))));
}
