// Parameters shared by the passes of the signal.
#ifndef COMPOSITE_VIDEO_SETTINGS
#define COMPOSITE_VIDEO_SETTINGS

#include "glass.glsl"
#include "video_signal.glsl"

uniform int standard = 0;    // @items "NTSC" "PAL"  @label "Standard"  @group "Signal"
                             // @help "NTSC is SMPTE 170M, with a subcarrier of 3.58 MHz. PAL is ITU-R BT.470, with 4.43 MHz and V inverted in every second line."
uniform int connection = 2;  // @items "RGB" "S-video" "Composite" "RF"  @label "Connection"  @group "Signal"
                             // @help "RGB has no colour subcarrier. S-video carries luma and chroma on two wires. Composite adds them. RF also sends the sum over an antenna cable."
uniform int interlace = 1;   // @items "Off" "Auto" "On"  @label "Interlacing"  @group "Signal"  @when connection != "RGB"
                             // @help "With interlacing, the subcarrier is inverted in every second frame, so its dots crawl. Without it, as from most consoles, they stand still. Auto interlaces 289 to 576 lines."

uniform vec3 u_source_lines;
uniform float u_time;

// Start, pitch and number of the lines, from the top of the picture. More than a television can
// show become 480 or 576.
vec3 signal_lines() {
    if (u_source_lines.z <= 600.0)
        return u_source_lines;
    float lines = standard == standard_pal ? 576.0 : 480.0;
    return vec3(0.0, 1.0 / lines, lines);
}

int field_number() {
    float rate = standard == standard_pal ? 50.0 : 60.0;
    return int(floor(u_time * rate + 1e-3)) & 7;
}

bool has_fields() {
    return is_interlaced(interlace, signal_lines().z);
}

// The distance of two lines that follow each other, in rows.
int row_step() {
    return has_fields() ? 2 : 1;
}

float phase_of(int row) {
    return line_phase(standard, line_number(standard, row, field_number(), has_fields()));
}

float v_sign_of(int row) {
    return v_sign(standard, line_number(standard, row, field_number(), has_fields()));
}

#endif
