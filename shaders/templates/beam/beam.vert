#version 410 core
// The beam: one rectangle around each segment of the signal's path. look.json asks for segments
// with "draw": "segments". The program then draws this shader once for each of them.
#include "beam_segment.glsl"
#include "reference_height.glsl"

in vec4 segment;       // -1..1, y up: start and end
in vec2 intensities;   // at start and end
in vec2 ages_seconds;  // time before the end of the frame: start and end

uniform vec2 u_resolution;
uniform float spot_size = 0.9;    // @range 0.5 6  @limit 0.1 100  @scale log  @label "Spot size"  @unit "px at 512 lines"  @group "Beam"
                                  // @help "Standard deviation of the spot. The light stays the same, so a wider spot is dimmer."
uniform float picture_size = 0.85;  // @range 0.3 1  @limit 0.05 4  @label "Size"  @unit "× picture size"  @group "Beam"
                                    // @help "How much of the picture the signal's range of -1 to 1 covers."

flat out vec4 ends;    // px from the bottom left
flat out vec2 charges; // light at start and end
flat out float sigma;  // px
flat out float age;    // s, mean

void main() {
    float shorter = min(u_resolution.x, u_resolution.y);
    float scale = u_resolution.y / reference_height;
    ends = 0.5 * u_resolution.xyxy + 0.5 * picture_size * shorter * segment;
    charges = intensities * scale * scale;
    sigma = spot_size * scale;
    age = 0.5 * (ages_seconds.x + ages_seconds.y);
    vec2 corner = beam_segment_corner(ends.xy, ends.zw, beam_segment_reach(sigma), gl_VertexID);
    gl_Position = vec4(2.0 * corner / u_resolution - 1.0, 0.0, 1.0);
}
