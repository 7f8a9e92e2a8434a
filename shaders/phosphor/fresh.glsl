// The light that reaches the phosphor in this frame: the beam's, or the source picture's.
#ifdef DRIVEN_BY_PICTURE
#include "picture_charge.glsl"
#else
#include "beam_kind.glsl"

uniform sampler2D current;   // the beam as points
uniform sampler2D segments;  // the beam as segments

vec4 fresh_at(vec2 at, float frame_seconds) {
    return draws_segments() ? texture(segments, at) : texture(current, at);
}
#endif
