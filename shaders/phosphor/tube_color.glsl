// The colours of a measured tube's light.
#include "spot.glsl"
#include "tube.glsl"

uniform int tube_color = 0;  // @items "The tube's own" "Beam colour" "Beam and afterglow colour"  @label "Tube colour"  @group "Phosphor"
                             // @help "A measured tube glows in its own colour, and as bright as it was against the others. Or choose: the beam's colour for all of its light, or that for the flash and another one for what glows on."
uniform vec3 afterglow_color = vec3(0.418, 1.0, 0.034);  // @color  @label "Afterglow colour"  @group "Phosphor"
                                                         // @help "What glows on after the flash of a measured tube, where Tube colour is 'Beam and afterglow colour'."

// Columns: what the first, second and third term add to red, green and blue.
mat3 term_colors() {
    if (tube_color == 0) {
        vec3 afterglow = tube_afterglow_color(tube);
        return mat3(tube_flash_colors[tube - 1], afterglow, afterglow);
    }
    vec3 afterglow = tube_color == 1 ? beam_color : afterglow_color;
    return mat3(beam_color, afterglow, afterglow);
}
