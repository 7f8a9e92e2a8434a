// The beam's light in this frame, from the pass that draws it.
#include "beam_kind.glsl"

uniform sampler2D current;   // the beam as points
uniform sampler2D segments;  // the beam as segments

vec4 fresh_at(vec2 at) {
    return draws_segments() ? texture(segments, at) : texture(current, at);
}
