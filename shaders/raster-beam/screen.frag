#version 410 core
// Screen: the lines with the spot's vertical size, through the mask and the glass. Reads linear
// light. Writes display values.
#include "barrel.glsl"
#include "color.glsl"
#include "convergence_settings.glsl"
#include "mask.glsl"
#include "noise.glsl"
#include "raster_settings.glsl"
#include "tonemap.glsl"

uniform sampler2D line;
uniform vec2 u_resolution;
uniform int u_frame;
uniform float u_peak;

uniform vec2 overscan = vec2(0.03);  // @range 0 0.1  @limit -0.5 0.9  @label "Overscan"  @group "Raster"  @identity 0
                                     // @help "Part of the width and height beyond the edges of the glass. Televisions hide about 5 %, monitors nothing. Below 0, a dark rim surrounds the raster."
uniform float retrace = 0.0;       // @range 0 0.2  @limit 0 10  @label "Vertical retrace"  @group "Raster"  @identity 0
                                   // @help "Light of the lines that the beam draws on its way back up. A tube shows them if its brightness is too high, or its blanking fails."
uniform int mask_type = 1;         // @items "None" "Aperture grille" "Slot mask" "Dot triads"  @label "Type"  @group "Mask"  @identity 0
                                   // @help "An aperture grille has vertical stripes. A slot mask cuts the stripes with bridges. Dot triads are typical of computer monitors."
uniform float mask_pitch = 0.6;    // @range 0.2 1.2  @limit 0.01 100  @label "Pitch"  @unit "mm"  @group "Mask"  @period "$mask_type > 0 && $panel == 0 ? $mask_pitch / $screen_width * $WIDTH : 0"  @when mask_type != "None"
                                   // @help "Distance from one red stripe or dot to the next. Televisions have 0.5 to 0.9 mm, monitors 0.22 to 0.3 mm."
uniform float screen_width = 400.0;  // @range 150 900  @limit 10 10000  @label "Screen width"  @unit "mm"  @group "Mask"  @when mask_type != "None"
                                     // @help "Width of the visible picture. 400 mm is a tube with a diagonal of 21 inches."
uniform float mask_strength = 0.6; // @range 0 1  @limit 0 1  @label "Strength"  @group "Mask"  @identity 0  @when mask_type != "None"
                                   // @help "0 turns the mask off. At 1, each stripe shows only its own colour."
uniform int panel = 0;             // @items "Whole pixels" "RGB" "BGR" "WOLED"  @label "Panel"  @group "Mask"  @when mask_type != "None"
                                   // @help "Subpixels of your display. Each colour of the mask is then where the display emits it. Only for a picture that is shown pixel by pixel."
uniform float curvature = 0.05;    // @range 0 0.3  @limit 0 0.9  @label "Curvature"  @group "Glass"  @identity 0
                                   // @help "How far the glass bulges towards the viewer. 0 is flat."
uniform float corner_radius = 0.04;  // @range 0 0.5  @limit 0 1  @label "Corner radius"  @unit "× half height"  @group "Glass"  @identity 0
                                     // @help "Corner radius of the glass. 0 gives square corners, 1 equals half the picture height."
uniform float exposure = 1.0;      // @range 0.1 16  @limit 0 1000  @scale log  @label "Exposure"  @group "Tone mapping"  @identity 1
                                   // @help "Brightness before tone mapping. Doubling it doubles the light."
uniform int tone_map = 0;          // @items "Clamp" "Reinhard" "ACES"  @label "Tone map"  @group "Tone mapping"
                                   // @help "How light brighter than the display is mapped to its range. The middle of a line and the stripes of a mask are brighter than the picture. Clamp cuts off each channel, Reinhard and ACES compress it softly."
uniform bool dither = true;        // @label "Dither"  @group "Tone mapping"  @identity 0
                                   // @help "Adds noise of half an 8-bit level, so that soft glows don't show bands."

in vec2 uv;
out vec4 color;

const float largest_size = 0.75;  // of the spot, in lines of a field
const float deviations = 3.0;     // of the spot, that are drawn to each side: 99.7 % of its light

// The lines of the field around a pixel. Red and blue are taken from whole lines away, and the rest
// of their offset is a distance. Lengths are in lines of the field.
struct Lines {
    vec3 light;
    vec3 total;  // of the spots of all lines
    vec3 whole;  // lines between a gun's line and that of green
    vec3 away;   // from each gun's line 0 to the pixel
    float x;     // of the pixel in the raster, 0..1
    float unit;  // a line of 240
    float pixel;
};

void add_line(inout Lines lines, float row) {
    float count = float(textureSize(line, 0).y);
    vec3 rows = (row + lines.whole + 0.5) / count;
    vec3 current = texture(line, vec2(lines.x, rows.g)).rgb;
    if (red_offset.y != 0.0)
        current.r = texture(line, vec2(lines.x, rows.r)).r;
    if (blue_offset.y != 0.0)
        current.b = texture(line, vec2(lines.x, rows.b)).b;
    vec3 size = min(lines.unit * spot_size(current, spot, spot_growth), largest_size);
    vec3 part = spot_light(lines.away - row, size, lines.pixel);
    lines.light += current * part;
    lines.total += part;
}

// The light at a place of the raster, 0..1 from its bottom left.
vec3 line_light(vec2 place) {
    Raster drawn = raster();
    float unit = 1.0 / (240.0 * drawn.pitch);
    float pixel = (1.0 - overscan.y) / (u_resolution.y * drawn.pitch);
    vec3 offset = unit * vec3(red_offset.y, 0.0, blue_offset.y);
    vec3 whole = floor(offset + 0.5);
    vec3 rest = abs(offset - whole);
    vec3 up = unit * vec3(red_at(2.0 * place - 1.0).y, 0.0, blue_at(2.0 * place - 1.0).y) - whole;
    float at = (1.0 - place.y - drawn.first) / drawn.pitch;
    float nearest = floor(at + 0.5);
    Lines lines = Lines(vec3(0.0), vec3(0.0), whole, at + up, place.x, unit, pixel);
    float widest = max(min(unit * spot_size(vec3(1.0), spot, spot_growth).g, largest_size), 0.5 * pixel);
    float drift = abs(convergence_edge) * unit + max(rest.r, rest.b);
    int reach = int(ceil(deviations * widest + drift - 0.5));
    int i = -reach;
    do {
        add_line(lines, nearest + float(i));
        ++i;
    } while (i <= reach);
    // In a picture that is lower than the raster, pixels reach beyond these lines.
    vec3 light = lines.light / mix(vec3(1.0), lines.total, smoothstep(0.6, 1.0, pixel));
    bool is_outside = place.x < 0.0 || place.x > 1.0;
    return is_outside ? vec3(0.0) : light;
}

// The beam goes back up in about ten line times. Each draws a stroke from left to right that rises
// by a tenth of the height.
vec3 retrace_light(vec2 place) {
    const float strokes = 10.0;
    float at = place.y * strokes - place.x;
    float away = (at - floor(at + 0.5)) / strokes * 240.0;  // in lines of 240
    float pixel = 240.0 / u_resolution.y;
    return retrace * spot_light(vec3(away), vec3(spot), pixel);
}

vec3 mask_at(vec2 px) {
    if (mask_type == 0)
        return vec3(1.0);
    float pitch = mask_pitch / screen_width * u_resolution.x;
    Mask mask = Mask(mask_type, pitch, 1.5, 0.5, 0.5);
    return mix(vec3(1.0), mask_light_on_panel(mask, px, 1.0, panel), mask_strength);
}

void main() {
    vec2 glass = barrel_radial(2.0 * uv - 1.0, curvature);
    vec2 place = 0.5 * glass * (1.0 - overscan) + 0.5;
    vec3 light = line_light(place);
    if (retrace > 0.0)
        light += retrace_light(place);
    light *= exposure * mask_at((0.5 * glass + 0.5) * u_resolution);
    light = tone_mapped_per_channel_to(light, tone_map, 0.0, u_peak);
    light *= glass_coverage(glass, u_resolution / u_resolution.y, corner_radius);
    vec3 display = srgb_encode_to(light, u_peak);
    color = vec4(dither ? dithered(display, uvec2(gl_FragCoord.xy), uint(u_frame)) : display, 1.0);
}
