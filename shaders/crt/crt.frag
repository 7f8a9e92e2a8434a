#version 410 core
// CRT: colour fringes, then one tone map, then scanlines. Reads linear light without an upper
// limit. Writes display values.
#include "color.glsl"
#include "glass.glsl"
#include "noise.glsl"
#include "tonemap.glsl"

uniform sampler2D scene;
uniform vec2 u_resolution;
uniform vec3 u_source_lines;
uniform float u_time;
uniform int u_frame;
uniform float u_peak;

uniform bool crt = true;  // @label "Enable CRT"  @group "CRT"
                          // @help "Off passes the picture through unchanged."
uniform bool as_written = false;  // @label "Original article"  @group "Article"  @when crt
                                  // @help "Uses the original article's formulas, mistakes included. Display values are clipped at 1 and darkened where light should be. Scanlines are sampled at pixel centres, so at 4 px they have two levels and lose 29 % of their depth."
uniform float aberration = 1.0;   // @range 0 8  @limit -64 64  @label "Chromatic aberration"  @unit "px"  @group "Aberration"  @identity 0  @when crt
                                  // @help "Colour fringes. Red is sampled this far to the right, blue this far to the left. Green stays in place. 0 turns it off. The article's formula for blue lacks a minus sign."
uniform float exposure = 1.0;     // @range 0.1 16  @limit 0 1000  @scale log  @label "Exposure"  @group "Tone mapping"  @identity 1  @when crt && !as_written
                                  // @help "Brightness before tone mapping. Doubling it doubles the light."
uniform int tone_map = 0;         // @items "Clamp" "Reinhard" "ACES" "Extended Reinhard" "AgX" "Khronos PBR Neutral" "None"  @items_was "" "" "" "" "" "Khronos neutral"  @label "Tone map"  @group "Tone mapping"  @identity 6  @when crt && !as_written
                                  // @help "How light brighter than the display is mapped to its range. Clamp cuts off each channel, which shifts the hue of bright colours. Reinhard maps 1 to 1/2. Extended Reinhard maps the white point to 1. ACES and AgX compress light as film does. Khronos PBR Neutral preserves colours up to 0.8. None passes the light on to the next look of a stack."
uniform float white = 2.0;        // @range 0.5 16  @limit 0.001 1000  @scale log  @label "White point"  @group "Tone mapping"  @when crt && !as_written && tone_map == "Extended Reinhard"
                                  // @help "Light that Extended Reinhard maps to full white. At 1, a light of 1 stays unchanged."
uniform float keep_hue = 0.0;     // @range 0 1  @limit 0 1  @label "Preserve hue"  @group "Tone mapping"  @identity 0  @when crt && !as_written
                                  // @help "0 maps each channel separately, so bright colours turn white. 1 scales all three channels together and keeps the hue."
uniform float scanline_strength = 0.3;  // @range 0 1  @limit 0 1  @label "Strength"  @group "Scanlines"  @identity 0  @when crt
                                        // @help "Depth of the scanlines: the fraction of the light that is lost between them. 0 turns them off."
uniform int scanline_unit = 0;          // @items "Pixels" "Source lines"  @label "Period unit"  @group "Scanlines"  @when crt && !as_written && scanline_strength > 0
                                        // @help "Unit of the scanline period. With Source lines, each line of the source gets its own scanline, wherever the source is placed in the picture."
uniform float scanline_period = 4.0;    // @range 2 16  @limit 1 1000  @label "Period"  @unit "px per period"  @group "Scanlines"  @period "$scanline_unit == 0 ? $scanline_period : 0"  @when crt && scanline_strength > 0 && (as_written || scanline_unit == "Pixels")
                                        // @help "Distance between scanlines, in pixels. It doesn't scale with the render size."
uniform float scanline_lines = 1.0;     // @range 0.5 4  @limit 0.25 64  @label "Lines per scanline"  @group "Scanlines"  @period "$scanline_unit == 0 ? 0 : $scanline_lines * $LINE * (1 + ($scanline_interlace == 2) + ($scanline_interlace == 1) * ($LINES > 288) * ($LINES <= 576))"  @when crt && !as_written && scanline_strength > 0 && scanline_unit == "Source lines"
                                        // @help "Number of source lines that each scanline covers. Only used when Period unit is Source lines."
uniform int scanline_interlace = 1;     // @items "Off" "Auto" "On"  @label "Interlacing"  @group "Scanlines"  @when crt && !as_written && scanline_strength > 0 && scanline_unit == "Source lines"
                                        // @help "Draws even and odd source lines in alternating fields, 60 fields per second. Auto does this for sources of 289 to 576 lines. Only used when Period unit is Source lines."
uniform float scanline_brightness = 1.0;  // @range 0 1  @limit 0 1  @label "Brightness compensation"  @group "Scanlines"  @when crt && !as_written && scanline_strength > 0
                                          // @help "0 lets the mean brightness fall to 1 - strength / 2, as in the article. 1 raises the crests until the mean is unchanged, as far as the display allows."
uniform bool dither = true;       // @label "Dither"  @group "Tone mapping"  @identity 0  @when crt && !as_written
                                  // @help "Adds noise of half an 8-bit level, so that soft glows don't show bands."

in vec2 uv;
out vec4 color;

vec3 fringed(vec2 shift) {
    vec3 middle = texture(scene, uv).rgb;
    if (shift.x == 0.0)
        return middle;
    return vec3(texture(scene, uv + shift).r, middle.g, texture(scene, uv - shift).b);
}

// Distance from the top, in px.
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
    light = mix(tone_mapped_to(light, tone_map, peak, u_peak),
                tone_mapped_keeping_hue_to(light, tone_map, peak, u_peak), keep_hue);
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
        vec3 display = tone_map == tone_map_none ? srgb_encode_unbounded(light)
                                                 : srgb_encode_to(light, u_peak);
        color = vec4(dither ? dithered(display, uvec2(gl_FragCoord.xy), uint(u_frame)) : display,
                     1.0);
    }
}
