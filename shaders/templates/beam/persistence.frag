#version 410 core
// Persistence: the light of this frame, and what is left of all earlier ones. Linear light.
// "persistence@1" in look.json is this pass in the previous frame.
#include "decay.glsl"

uniform sampler2D beam;
uniform sampler2D previous;
uniform float u_time_delta;  // duration of this frame, s

in vec2 uv;
out vec4 color;

void main() {
    vec2 stored = texture(previous, uv).rg * left_after(u_time_delta) + texture(beam, uv).rg;
    color = vec4(stored, 0.0, 1.0);
}
