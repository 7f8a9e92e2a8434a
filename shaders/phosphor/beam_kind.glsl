#ifndef PHOSPHOR_BEAM_KIND
#define PHOSPHOR_BEAM_KIND

#include "as_written.glsl"

uniform int beam_kind = 0;  // @items "Points" "Segments"  @label "Drawn as"  @group "Beam"
                            // @help "Points: a spot for each instant that the signal gives; where the beam is fast and points are few, they show as pearls on a string. Segments: the exact light of a beam that runs evenly from instant to instant; slower to draw, for few points or very fast beams."

bool draws_segments() {
    return beam_kind == 1 && !as_written;
}

#endif
