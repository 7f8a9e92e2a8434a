// Where the signal's -1..1 lies in the picture.
#ifndef PHOSPHOR_FIT
#define PHOSPHOR_FIT

uniform int fit = 0;  // @items "Fill the picture" "Keep circles round"  @label "Fit"  @group "Screen"
                      // @help "Fill stretches the signal over the whole picture. Keep circles round draws both axes at the same scale, as a scope in X-Y does, and leaves the rest of a wide picture to the glass."

// Width and height of the signal's square, as shares of the picture's.
vec2 signal_size(vec2 resolution) {
    if (fit == 0)
        return vec2(1.0);
    return vec2(min(resolution.x, resolution.y)) / resolution;
}

#endif
