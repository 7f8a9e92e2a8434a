#ifndef PHOSPHOR_CEILING
#define PHOSPHOR_CEILING

uniform float ceiling = 2.5;  // @range 0.5 20  @limit 0.01 1000  @scale log  @label "Ceiling"  @group "Phosphor"
                              // @help "The brightest that the phosphor can get. A trace that stays in one place would grow without end; here it saturates."

#endif
