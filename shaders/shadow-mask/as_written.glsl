#ifndef SHADOW_MASK_AS_WRITTEN
#define SHADOW_MASK_AS_WRITTEN

uniform bool as_written = false;  // @label "As the article wrote it"  @group "Article"
                                  // @help "Draws with the formulas of the article that this look comes from, mistakes included: cells read at their edges, even columns half a cell too low; a mask of hard pixels that flickers on curved glass and darkens; display values where light should be; black at every side. What the text leaves undefined is read as docs/looks.md says."

#endif
