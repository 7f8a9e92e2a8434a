#version 410 core
// Bloom, one direction, at half the picture's size.
#include "blur.glsl"
#include "reference_height.glsl"

uniform sampler2D image;
uniform vec2 direction;  // (1, 0) or (0, 1)
uniform float level;     // mipmap level of the image; the tube's is half its size, like this pass
uniform vec2 u_resolution;
uniform float bloom_radius = 6.0;  // @range 0.5 30  @limit 0.1 100  @label "Radius"  @unit "px at 512 lines"  @group "Bloom"  @when bloom_intensity > 0  @photo amount
                                   // @help "How far the light spreads: one standard deviation, in pixels of a picture 512 pixels high."

in vec2 uv;
out vec4 color;

void main() {
    float sigma = max(0.5 * bloom_radius * u_resolution.y / (0.5 * reference_height), 0.1);
    vec2 texel = direction / u_resolution;
    int reach = int(ceil(3.5 * sigma));
    color = vec4(gaussian_blur(image, uv, texel, sigma, reach, level), 1.0);
}
