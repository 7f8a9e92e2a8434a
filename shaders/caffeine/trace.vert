#version 410 core
// Full-screen triangle of the path tracer. It is off screen while Original article is on.
#include "as_written.glsl"

void main() {
    vec2 place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(as_written ? vec2(-3.0) : 2.0 * place - 1.0, 0.0, 1.0);
}
