// What both the tube and the screen must agree on.
#ifndef SHADOW_MASK_GLASS
#define SHADOW_MASK_GLASS

uniform float curvature = 0.08;  // @range 0 0.3  @limit 0 0.9  @label "Curvature"  @group "Glass"  @identity 0
                                 // @help "How much the glass bulges towards you. The middles of the sides stay where they are."

#endif
