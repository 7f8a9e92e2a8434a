// Parameters shared by the passes tube and screen.
#ifndef SHADOW_MASK_GLASS
#define SHADOW_MASK_GLASS

uniform float curvature = 0.08;  // @range 0 0.3  @limit 0 0.9  @label "Curvature"  @group "Glass"  @identity 0  @photo shape
                                 // @help "How far the glass bulges towards the viewer. 0 is flat. The middle of each side stays in place."

#endif
