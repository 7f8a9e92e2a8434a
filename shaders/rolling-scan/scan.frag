#version 410 core
// Rolling scan: each sub-frame shows what the beam draws and the phosphor emits in its time. Reads
// linear light. Writes display values.
#include "color.glsl"
#include "noise.glsl"
#include "rolling_scan.glsl"

uniform sampler2D picture;
uniform sampler2D previous;
uniform int u_subframe;
uniform int u_subframes;
uniform int u_frame;
uniform float u_peak;

uniform int scan = 0;             // @items "Rolling scan" "Black frames" "Off"  @label "Scan"  @group "Scan"  @identity 2
                                  // @help "Rolling scan lights the rows one after the other, as the beam of a tube does. Black frames lights the whole picture in the first sub-frames. Off shows the steady picture."
uniform int subframes = 4;        // @range 1 16  @limit 1 16  @label "Sub-frames"  @group "Scan"
                                  // @help "Frames per source picture. 4 needs a display with 240 Hz for a source with 60 Hz. The window draws fewer if the display is too slow for them."
uniform float brightness = 0.7;   // @range 0.3 1  @limit 0 16  @label "Brightness"  @group "Scan"  @identity 1
                                  // @help "Mean light, relative to the steady picture. Less light needs less time, so moving objects are sharper."
uniform float persistence = 0.06; // @range 0 0.5  @limit 0 0.5  @label "Persistence"  @unit "source frames"  @group "Scan"  @when scan == "Rolling scan"
                                  // @help "Time in which the light of the phosphor falls to 37 %. 0.06 is 1 ms at 60 Hz, as of a colour tube."
uniform int direction = 0;        // @items "Down" "Up" "Right" "Left"  @label "Direction"  @group "Scan"  @when scan == "Rolling scan"
                                  // @help "Direction in which the beam moves from line to line. Right and Left are for a tube on its side."
uniform float retrace = 0.08;     // @range 0 0.2  @limit 0 0.9  @label "Vertical retrace"  @unit "source frames"  @group "Scan"  @when scan == "Rolling scan"
                                  // @help "Time in which the beam returns to the start. It is 8 % of a field with 525 or 625 lines."
uniform bool dither = true;       // @label "Dither"  @group "Scan"  @identity 0
                                  // @help "Adds noise of half an 8-bit level, so that soft glows don't show bands."

in vec2 uv;
out vec4 color;

// When the beam reaches this place, in source frames.
float reached() {
    float along[] = float[](1.0 - uv.y, uv.y, uv.x, 1.0 - uv.x);
    return scan == 1 ? 0.0 : along[direction] * (1.0 - retrace);
}

void main() {
    vec3 now = max(texture(picture, uv).rgb, 0.0);
    vec3 before = max(texture(previous, uv).rgb, 0.0);
    vec3 light = now;
    if (scan < 2)
        light = u_peak * rolling_light(brightness * now / u_peak, brightness * before / u_peak,
                                       reached(), u_subframe, u_subframes,
                                       scan == 1 ? 0.0 : persistence);
    vec3 display = srgb_encode_to(light, u_peak);
    color = vec4(dither ? dithered(display, uvec2(gl_FragCoord.xy), uint(u_frame)) : display, 1.0);
}
