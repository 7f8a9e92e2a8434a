// Parameters shared by the passes of the raster.
#ifndef RASTER_BEAM_SETTINGS
#define RASTER_BEAM_SETTINGS

#include "raster.glsl"

uniform int raster_lines = 0;  // @items "Source" "240" "288" "480" "576"  @label "Lines"  @group "Raster"
                               // @help "Lines of a frame. Source takes those of the picture, or 480 if it has more than 600. A television has 480 visible lines at 60 Hz and 576 at 50 Hz. Consoles and arcade boards often draw half of them."
uniform int interlace = 1;     // @items "Off" "Auto" "On"  @label "Interlacing"  @group "Raster"
                               // @help "Draws even and odd lines in alternating fields, 60 fields per second. Auto does this for 289 to 576 lines."
uniform float spot = 0.24;     // @range 0.12 0.5  @limit 0.05 0.75  @label "Spot size"  @unit "× line of 240"  @group "Beam"
                               // @help "Standard deviation of the spot at a weak current. 0.2 leaves dark gaps between 240 lines. 0.4 fills them."
uniform float spot_growth = 0.5;  // @range 0 1.5  @limit 0 3  @label "Spot growth"  @group "Beam"  @identity 0
                                  // @help "How much larger the spot is at full current. Bright lines are then wider than dark ones."

uniform vec3 u_source_lines;
uniform float u_time;

const float own_lines[] = float[](0.0, 240.0, 288.0, 480.0, 576.0);
const float most_source_lines = 600.0;

// Start, pitch and number of the lines of a frame.
vec3 frame_lines() {
    if (raster_lines == 0 && u_source_lines.z <= most_source_lines)
        return u_source_lines;
    float lines = raster_lines == 0 ? 480.0 : own_lines[raster_lines];
    return vec3(0.0, 1.0 / lines, lines);
}

Raster raster() {
    vec3 lines = frame_lines();
    return raster_of(lines, is_interlaced(interlace, lines.z) ? field_at(u_time) : -1.0);
}

#endif
