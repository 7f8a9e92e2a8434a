#ifndef VECTOR_BEAM_AS_WRITTEN
#define VECTOR_BEAM_AS_WRITTEN

uniform bool as_written = false;  // @label "As the article wrote it"  @group "Article"
                                  // @help "Draws with the article's own formulas, mistakes included: a wider spot is brighter, a resting spot does not fade within its frame, erf lacks a term, fading counts frames and not time. No glow, no tone map."

#endif
