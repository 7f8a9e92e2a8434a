#version 410 core
// Full-screen triangle of the article's passes. It is off screen unless Original article is on.
#include "molecule.glsl"  // first, because the panel lists parameters in declaration order
#include "as_written.glsl"

void main() {
    vec2 place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(as_written ? 2.0 * place - 1.0 : vec2(-3.0), 0.0, 1.0);
}
