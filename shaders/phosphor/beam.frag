#version 410 core
// The beam: the light of one spot, added to that of all others in the frame. Linear light.
// For a measured tube, it is charge without colour. Red, green and blue are the parts that the
// three terms have emitted by the end of the frame. Alpha is all of it.
// Energy of a point, summed over all pixels (px^2), for any position between them:
//   beam_gain * intensity * width^2 * pi * (1 / core_sharpness + glow_weight / glow_sharpness)
// with width = beam_width * height / 512 px. For the custom tube, each channel is also multiplied
// by beam_color.
#include "spot.glsl"
#include "as_written.glsl"
#include "gaussian.glsl"
#include "one_color.glsl"
#include "tube.glsl"

flat in vec2 middle;
flat in float width;
flat in vec4 charge;
out vec4 color;

float spot() {
    vec2 offset = gl_FragCoord.xy - middle;
    float px = width * width;
    return gaussian_over_pixel(offset, core_sharpness / px) +
           glow_weight * gaussian_over_pixel(offset, glow_sharpness / px);
}

// Sampled at the centre of each pixel. Cut off at the square's edge, at 3 % of the peak.
float spot_as_written() {
    vec2 offset = gl_PointCoord - 0.5;
    float square = dot(offset, offset);
    return exp(-core_sharpness * square) + glow_weight * exp(-glow_sharpness * square);
}

void main() {
    vec4 brightness = beam_gain * charge * (as_written ? spot_as_written() : spot());
    vec3 shade = has_one_color() ? vec3(1.0) : beam_color;
    color = has_tube() ? brightness : vec4(shade * brightness.rgb, 1.0);
}
