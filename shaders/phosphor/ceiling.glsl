#ifndef PHOSPHOR_CEILING
#define PHOSPHOR_CEILING

uniform float ceiling = 2.5;  // @range 0.5 20  @limit 0.01 1000  @scale log  @label "Brightness limit"  @group "Phosphor"
                              // @help "Maximum brightness of the phosphor. A trace that stays in one place saturates here instead of growing without limit."

#endif
