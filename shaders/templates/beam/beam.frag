#version 410 core
// The beam's light in this frame, added up over all segments ("blend": "add"). Linear light.
// Red: what is left in the flash layer at the end of the frame. Green: in the afterglow layer.
#include "beam_segment.glsl"
#include "decay.glsl"

flat in vec4 ends;
flat in vec2 charges;
flat in float sigma;
flat in float age;
out vec4 color;

void main() {
    float light = beam_segment_over_pixel(gl_FragCoord.xy, ends.xy, ends.zw, sigma, 0.0, charges);
    color = vec4(light * left_after(age), 0.0, 1.0);
}
