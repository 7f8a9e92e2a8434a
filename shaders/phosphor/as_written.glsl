#ifndef PHOSPHOR_AS_WRITTEN
#define PHOSPHOR_AS_WRITTEN

uniform bool as_written = false;  // @label "Original article"  @group "Article"  @photo start 0
                                  // @help "Uses the original article's formulas, mistakes included: spots cut to squares, a blur with two humps, and a decay that depends on the frame rate."

#endif
