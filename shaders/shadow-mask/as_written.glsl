#ifndef SHADOW_MASK_AS_WRITTEN
#define SHADOW_MASK_AS_WRITTEN

uniform bool as_written = false;  // @label "As the article wrote it"  @group "Article"
                                  // @help "Draws with the formulas of the article that this look comes from, mistakes included: cells read at their edges, a mask of hard pixels that darkens, display values where light should be, and black at every side."

#endif
