#version 410 core
// The triangle of the article's passes; none of it is on the screen while its picture is not wanted.
#include "molecule.glsl"  // its knobs come first in the panel: the first mention decides
#include "as_written.glsl"

void main() {
    vec2 place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(as_written ? 2.0 * place - 1.0 : vec2(-3.0), 0.0, 1.0);
}
