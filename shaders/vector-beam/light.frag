#version 410 core
// Light: how strongly the phosphor shone during the frame, per 1/60 s. Linear light, grey.
#include "as_written.glsl"

uniform sampler2D phosphor;
uniform float u_time_delta;

in vec2 uv;
out vec4 color;

void main() {
    float given = texture(phosphor, uv).g;
    float light = as_written ? given : given / (60.0 * u_time_delta);
    color = vec4(vec3(min(light, 60000.0)), 1.0);  // below the largest half float
}
