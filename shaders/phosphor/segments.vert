#version 410 core
// The beam as segments: one rectangle around the path from each point to the next, with a margin
// for the spot's width.
#include "beam_kind.glsl"
#include "beam_segment.glsl"
#include "fit.glsl"
#include "reference_height.glsl"
#include "spot.glsl"
#include "tint.glsl"

uniform vec2 u_resolution;
uniform float u_time_delta;

in vec4 segment;        // -1..1, y up: start, end
in vec2 intensities;    // 1: full current for 1/4096 of 1/60 s
in vec2 ages_seconds;   // time before the end of the frame: start, end

flat out vec4 ends;     // px from the bottom left
flat out vec2 charges;  // at start and end; their mean is the charge of the segment
flat out vec2 ages;     // s
flat out vec2 sigmas;   // of core and glow, px
flat out vec2 areas;    // light of core and glow for a charge of 1, px^2
flat out vec4 colors;   // of the charge

// Narrower spots look the same within a pixel but need many samples.
const float least_sigma = 0.25;  // px

const float pi = 3.14159265359;

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    if (!draws_segments())
        return;
    ends = (0.5 + 0.5 * segment * signal_size(u_resolution).xyxy) * u_resolution.xyxy;
    charges = intensities;
    colors = tint_of_charge();
    ages = min(ages_seconds, u_time_delta);  // a path from the previous frame counts for this one
    float width = beam_width * u_resolution.y / reference_height;
    vec2 sharpness = vec2(core_sharpness, glow_sharpness);
    areas = pi * width * width * vec2(1.0, glow_weight) / sharpness;
    sigmas = max(width * inversesqrt(2.0 * sharpness), least_sigma);
    float widest = glow_weight > 0.0 ? max(sigmas.x, sigmas.y) : sigmas.x;
    vec2 corner = beam_segment_corner(ends.xy, ends.zw, beam_segment_reach(widest), gl_VertexID);
    gl_Position = vec4(2.0 * corner / u_resolution - 1.0, 0.0, 1.0);
}
