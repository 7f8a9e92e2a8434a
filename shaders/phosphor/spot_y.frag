#version 410 core
// The source picture on the tube, blurred vertically by the spot. Linear light.
#include "picture_spot.glsl"

uniform sampler2D image;
uniform vec2 u_resolution;

in vec2 uv;
out vec4 color;

void main() {
    vec2 texel = vec2(0.0, 1.0 / u_resolution.y);
    color = vec4(drawn_by_spot(image, uv, texel, u_resolution.y), 1.0);
}
