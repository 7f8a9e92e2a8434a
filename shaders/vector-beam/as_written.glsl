#ifndef VECTOR_BEAM_AS_WRITTEN
#define VECTOR_BEAM_AS_WRITTEN

uniform bool as_written = false;  // @label "Original article"  @group "Article"  @photo start 0
                                  // @help "Uses the original article's formulas, mistakes included. A wider spot is brighter, a resting spot doesn't fade within its frame, and erf lacks a term. Fading counts frames instead of time. Glow and tone mapping are off."

#endif
