#ifndef SHADOW_MASK_AS_WRITTEN
#define SHADOW_MASK_AS_WRITTEN

uniform bool as_written = false;  // @label "Original article"  @group "Article"
                                  // @help "Uses the original article's formulas, mistakes included. Cells are read at their edges, even columns half a cell too low. The mask has hard pixels: it flickers on curved glass and darkens the picture. Display values replace light, and all edges are black. docs/looks.md explains how undefined parts of the text are read."

#endif
