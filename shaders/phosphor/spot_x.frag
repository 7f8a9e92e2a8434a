#version 410 core
// The source picture on the tube, blurred horizontally by the spot. Linear light. A monochrome
// phosphor gets its luminance, as a monochrome monitor does.
#include "color.glsl"
#include "fit.glsl"
#include "one_color.glsl"
#include "picture_spot.glsl"

uniform sampler2D picture;
uniform vec2 u_resolution;

in vec2 uv;
out vec4 color;

void main() {
    vec2 at = (uv - 0.5) / screen_size + 0.5;
    vec2 texel = vec2(1.0 / (screen_size * u_resolution.x), 0.0);
    vec3 light = max(drawn_by_spot(picture, at, texel, u_resolution.y), 0.0);
    bool is_monochrome = has_tube() || has_one_color();
    color = vec4(is_monochrome ? vec3(luminance(light)) : light, 1.0);
}
