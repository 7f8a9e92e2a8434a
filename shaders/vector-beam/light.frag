#version 410 core
// Light: mean brightness of the phosphor during the frame, per 1/60 s. Linear light, grey
// except for the beam's own colour.
#include "as_written.glsl"
#include "tint.glsl"

uniform sampler2D phosphor;
uniform float u_time_delta;

in vec2 uv;
out vec4 color;

void main() {
    vec4 glowing = texture(phosphor, uv);
    float given = glowing.g;
    float light = as_written ? given : given / (60.0 * u_time_delta);
    // Limited to stay below the largest half float.
    color = vec4(min(min(light, 60000.0) * color_of(glowing.ba), 60000.0), 1.0);
}
