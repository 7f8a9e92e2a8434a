#include "formats/effect/shader_functions.h"

const char* const decoding_function = R"(
// sRGB to linear light, IEC 61966-2-1.
vec4 display_to_linear(vec4 display) {
    vec3 curve = pow((display.rgb + 0.055) / 1.055, vec3(2.4));
    bvec3 is_dark = lessThanEqual(display.rgb, vec3(0.04045));
    return vec4(mix(curve, display.rgb / 12.92, is_dark), display.a);
}
)";

const char* const border_function = R"(
// Transparent black beyond the edges.
vec4 bordered(vec4 read, vec2 at, vec2 size, bool is_smooth) {
    vec2 place = at * size;
    vec2 inside = is_smooth ? clamp(place + 0.5, 0.0, 1.0) * clamp(size - place + 0.5, 0.0, 1.0)
                            : step(vec2(0.0), place) * step(place, size);
    return read * inside.x * inside.y;
}
)";

const char* const level_function = R"(
// The mip level that texture() reads, which is the same for four pixels.
float level_at(vec2 place) {
    vec2 odd = vec2(ivec2(gl_FragCoord.xy) & 1);
    vec2 across = dFdx(place);
    vec2 up = dFdy(place);
    across -= odd.y * dFdy(across);
    up -= odd.x * dFdx(up);
    float square = max(max(dot(across, across), dot(up, up)), 1e-30);
    float whole = floor(log2(square));
    return 0.5 * (whole + square * exp2(-whole) - 1.0);
}
)";
