#ifndef PHOSPHOR_AS_WRITTEN
#define PHOSPHOR_AS_WRITTEN

uniform bool as_written = false;  // @label "As the article wrote it"  @group "Article"
                                  // @help "Draws with the formulas of the article that this look comes from, mistakes included: spots cut to squares, a blur with two humps, fading that depends on the frame rate."

#endif
