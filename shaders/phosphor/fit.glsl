// Maps the signal's -1..1 to the picture.
#ifndef PHOSPHOR_FIT
#define PHOSPHOR_FIT

#ifdef DRIVEN_BY_PICTURE
const int fit = 0;  // a source picture has its own fit
#else
uniform int fit = 0;  // @items "Fill the picture" "Keep circles round"  @label "Fit"  @group "Screen"
                      // @help "Fill the picture stretches the signal over the whole picture. Keep circles round draws both axes at the same scale, as a scope in XY mode does. A wide picture then has margins."
#endif
uniform float screen_size = 1.0;  // @range 0.5 1  @limit 0.05 2  @label "Size"  @unit "× picture size"  @group "Screen"
                                  // @help "How much of the picture the signal and the graticule cover, or the source picture. 1 is all of it, less leaves a margin."

// Width and height of the signal's -1..1, as fractions of the picture's.
vec2 signal_size(vec2 resolution) {
    vec2 shape = fit == 0 ? vec2(1.0) : min(resolution.x, resolution.y) / resolution;
    return screen_size * shape;
}

#endif
