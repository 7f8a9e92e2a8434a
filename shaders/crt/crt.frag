#version 410 core
// CRT: fringes, then one tone map, then scanlines. Reads linear light without an upper end and writes
// display values.
#include "color.glsl"
#include "glass.glsl"
#include "noise.glsl"
#include "tonemap.glsl"

uniform sampler2D scene;
uniform vec2 u_resolution;
uniform vec3 u_source_lines;
uniform float u_time;
uniform int u_frame;

uniform bool crt = true;  // @label "CRT"  @group "CRT"
                          // @help "Off: the scene as it is, a plain copy."
uniform bool as_written = false;  // @label "As the article wrote it"  @group "CRT"
                                  // @help "Draws with the formulas of the article that this look comes from: display values are cut off at 1 and darkened where light should be, and the scanlines are sampled in the middle of each pixel, so that at 4 px they have two levels and lose 29 % of their depth."
uniform float aberration = 1.0;   // @range 0 8  @limit -64 64  @label "Aberration"  @unit "px"  @group "Aberration"  @identity 0
                                  // @help "Colour fringes: red is read this far to the right, blue this far to the left, green stays. (The article's formula for blue has lost its minus.)"
uniform float exposure = 1.0;     // @range 0.1 16  @limit 0 1000  @scale log  @label "Exposure"  @group "Tone map"  @identity 1
                                  // @help "Brightness before the tone map: twice as much doubles the light."
uniform int tone_map = 0;         // @items "Clamp" "Reinhard" "ACES" "Extended Reinhard" "AgX" "Khronos neutral" "None"  @label "Tone map"  @group "Tone map"  @identity 6
                                  // @help "How light brighter than the screen is brought back to it. Clamp cuts each channel off and leaves all else alone, which shifts the hue of what is too bright; Reinhard makes 1 into 1/2; Extended Reinhard makes the set white into 1; ACES and AgX bend as film does; Khronos neutral keeps colours up to 0.8. None hands the light on to the next look of a stack."
uniform float white = 2.0;        // @range 0.5 16  @limit 0.001 1000  @scale log  @label "White"  @group "Tone map"
                                  // @help "The light that Extended Reinhard turns to full white. At 1 it leaves a light of 1 as it is."
uniform float keep_hue = 0.0;     // @range 0 1  @limit 0 1  @label "Keep hue"  @group "Tone map"  @identity 0
                                  // @help "0: what is too bright turns white, channel by channel. 1: all three channels come down together, and the colour stays."
uniform float scanline_strength = 0.3;  // @range 0 1  @limit 0 1  @label "Strength"  @group "Scanlines"  @identity 0
                                        // @help "Depth of the stripes: between them this share of the light is lost."
uniform int scanline_unit = 0;          // @items "Pixels" "Source lines"  @label "Period in"  @group "Scanlines"
                                        // @help "What the period is counted in. With source lines each line of the source gets its own stripe, wherever the fit places it in the picture."
uniform float scanline_period = 4.0;    // @range 2 16  @limit 1 1000  @label "Period"  @unit "px a period"  @group "Scanlines"  @period "$scanline_unit == 0 ? $scanline_period : 0"
                                        // @help "From stripe to stripe in pixels of the picture, whatever its size."
uniform float scanline_lines = 1.0;     // @range 0.5 4  @limit 0.25 64  @label "Lines per scanline"  @group "Scanlines"  @period "$scanline_unit == 0 ? 0 : $scanline_lines * $LINE * (1 + ($scanline_interlace == 2) + ($scanline_interlace == 1) * ($LINES > 288) * ($LINES <= 576))"
                                        // @help "How many lines of the source a scanline covers, where the period is counted in them."
uniform int scanline_interlace = 1;     // @items "Off" "Auto" "On"  @label "Interlace"  @group "Scanlines"
                                        // @help "Draws even and odd lines of the source by turns, 60 fields a second, where the period is counted in source lines. Auto: for sources of 289 to 576 lines."
uniform float scanline_brightness = 1.0;  // @range 0 1  @limit 0 1  @label "Brightness kept"  @group "Scanlines"
                                          // @help "0: the mean falls to 1 - strength / 2, as in the article, which makes up for nothing. 1: the crests are raised until the mean is what it was, as far as the screen can show."
uniform bool dither = true;       // @label "Dither"  @group "Tone map"  @identity 0
                                  // @help "Noise of half a screen step, so that soft glows show no bands."

in vec2 uv;
out vec4 color;

vec3 fringed(vec2 shift) {
    vec3 middle = texture(scene, uv).rgb;
    if (shift.x == 0.0)
        return middle;
    return vec3(texture(scene, uv + shift).r, middle.g, texture(scene, uv - shift).b);
}

// Down from the top, in px.
float scan_place() {
    return (1.0 - uv.y) * u_resolution.y;
}

vec3 as_the_article_wrote(vec2 shift) {
    vec3 shown = clamp(srgb_encode_unbounded(fringed(shift)), 0.0, 1.0);
    float wave = sin(6.28318530718 * scan_place() / scanline_period);
    return shown * (1.0 - scanline_strength * (0.5 + 0.5 * wave));
}

float scanlines() {
    if (scanline_unit == 0)
        return scanline_factor(scan_place(), scanline_period, scanline_strength);
    float line = (1.0 - uv.y - u_source_lines.x) / u_source_lines.y;
    float field = is_interlaced(scanline_interlace, u_source_lines.z) ? field_at(u_time) : -1.0;
    return source_scanline_factor(line, scanline_lines, u_source_lines.y * u_resolution.y, field,
                                  scanline_strength);
}

vec3 tube_light(vec2 shift) {
    vec3 light = fringed(shift) * exposure;
    float peak = tone_map == tone_map_reinhard_to_white ? white : 0.0;
    light = mix(tone_mapped(light, tone_map, peak),
                tone_mapped_keeping_hue(light, tone_map, peak), keep_hue);
    float mean = 1.0 - 0.5 * scanline_strength;
    return light * scanlines() / mix(1.0, mean, scanline_brightness);
}

void main() {
    vec2 shift = vec2(aberration / u_resolution.x, 0.0);
    if (!crt) {
        color = vec4(srgb_encode_unbounded(texture(scene, uv).rgb), 1.0);
    } else if (as_written) {
        color = vec4(as_the_article_wrote(shift), 1.0);
    } else {
        vec3 light = tube_light(shift);
        vec3 display = tone_map == tone_map_none ? srgb_encode_unbounded(light) : srgb_encode(light);
        color = vec4(dither ? dithered(display, uvec2(gl_FragCoord.xy), uint(u_frame)) : display,
                     1.0);
    }
}
