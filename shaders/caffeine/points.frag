#version 410 core
// The Sobol points, drawn once. Row n is point n. Each texel holds four dimensions, exactly.
#include "sobol.glsl"

out vec4 color;

void main() {
    uint index = uint(gl_FragCoord.y);
    int first = 4 * int(gl_FragCoord.x);
    uvec4 digits = uvec4(sobol_digits(index, first), sobol_digits(index, first + 1),
                         sobol_digits(index, first + 2), sobol_digits(index, first + 3));
    color = fractions(digits);
}
