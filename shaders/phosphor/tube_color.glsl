// The colours of a measured tube's light.
#include "spot.glsl"
#include "tube.glsl"

uniform int tube_color = 0;  // @items "Tube default" "Beam colour" "Beam and afterglow colour"  @items_was "The tube's own" "" ""  @label "Tube colour"  @group "Phosphor"  @when !as_written && tube != "Custom"  @photo start 0
                             // @help "Tube default uses the measured tube's own colour, and its brightness relative to other tubes. Beam colour replaces it for all light. Beam and afterglow colour uses the beam colour for the flash and Afterglow colour for the rest."
uniform vec3 afterglow_color = vec3(0.418, 1.0, 0.034);  // @color  @label "Afterglow colour"  @group "Phosphor"  @when !as_written && tube != "Custom" && tube_color == "Beam and afterglow colour"
                                                         // @help "Colour of a measured tube's afterglow. Only used when Tube colour is Beam and afterglow colour."

// Columns: what the first, second and third term add to red, green and blue.
mat3 term_colors() {
    if (tube_color == 0) {
        vec3 afterglow = tube_afterglow_color(tube);
        return mat3(tube_flash_colors[tube - 1], afterglow, afterglow);
    }
    vec3 afterglow = tube_color == 1 ? beam_color : afterglow_color;
    return mat3(beam_color, afterglow, afterglow);
}
