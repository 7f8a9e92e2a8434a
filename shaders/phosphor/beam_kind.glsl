#ifndef PHOSPHOR_BEAM_KIND
#define PHOSPHOR_BEAM_KIND

#include "as_written.glsl"

uniform int beam_kind = 0;  // @items "Points" "Segments"  @label "Draw beam as"  @group "Beam"  @when !as_written
                            // @help "Points draws one spot for each sample of the signal. Where the beam is fast and samples are few, separate dots show. Segments draws the exact light of a beam that moves evenly from sample to sample. It is slower, for few samples or very fast beams."

bool draws_segments() {
    return beam_kind == 1 && !as_written;
}

#endif
