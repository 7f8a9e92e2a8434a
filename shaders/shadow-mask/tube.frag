#version 410 core
// Tube: the light that passes the mask. Reads and writes linear light (with Original article:
// writes display values). Lengths are in px of the tube, from its bottom left.
#include "barrel.glsl"
#include "color.glsl"
#include "glass.glsl"
#include "mask.glsl"

uniform sampler2D scene;
uniform vec2 u_resolution;
uniform vec2 u_source_resolution;
uniform vec3 u_source_lines;
uniform vec3 u_source_columns;
uniform float u_time;
uniform float u_time_delta;

uniform int mask_type = 0;          // @items "Staggered cells" "Aperture grille" "Slot mask" "Dot triads"  @label "Type"  @group "Mask"  @when !as_written && (mask_strength > 0 || sampling != "Continuous")  @photo type
                                    // @help "Staggered cells are the article's. An aperture grille has vertical stripes. A slot mask cuts the stripes with bridges. Dot triads are typical of computer monitors."
uniform int mask_unit = 0;          // @items "Pixels" "Triads across"  @label "Pitch unit"  @group "Mask"  @when as_written || mask_strength > 0 || sampling != "Continuous"
                                    // @help "How the pitch is set: in pixels, or as the number of red, green and blue triads across the picture, independent of the render size."
uniform float mask_size = 6.0;      // @range 2 32  @limit 0.5 256  @label "Pitch"  @unit "px per period"  @group "Mask"  @period "$mask_unit == 0 ? ($mask_snap == 1 ? max(round($mask_size), 1) : $mask_size) : 0"  @when mask_unit == "Pixels" && (as_written || mask_strength > 0 || sampling != "Continuous")  @photo pitch
                                    // @help "Distance from one red stripe or dot to the next. Below 3 px the mask fades. Below 2 px it is an even grey, as no display could show it."
uniform float mask_triads = 320.0;  // @range 60 1200  @limit 1 20000  @scale log  @label "Triads"  @unit "across"  @group "Mask"  @period "$mask_unit == 0 ? 0 : $mask_snap == 1 ? max(round($WIDTH / $mask_triads), 1) : $WIDTH / $mask_triads"  @when mask_unit == "Triads across" && (as_written || mask_strength > 0 || sampling != "Continuous")  @photo pitch
                                    // @help "Number of triads across the picture. A 21-inch television had 500 to 800, an arcade monitor 300 to 400. Only used when Pitch unit is Triads across."
uniform bool mask_snap = false;     // @label "Snap to whole pixels"  @group "Mask"  @when as_written || mask_strength > 0 || sampling != "Continuous"
                                    // @help "Rounds the pitch to a whole number of pixels, so that all cells look alike."
uniform float cell_height = 1.0;    // @range 0.5 4  @limit 0.1 20  @label "Cell height"  @unit "× pitch"  @group "Mask"  @when !as_written && (mask_strength > 0 || sampling != "Continuous") && (mask_type == "Staggered cells" || mask_type == "Slot mask")
                                    // @help "Height of cells and slots, as a multiple of the pitch. It has no effect on aperture grilles and dot triads."
uniform float mask_stagger = 0.5;   // @range 0 0.5  @limit 0 1  @label "Stagger"  @unit "× cell height"  @group "Mask"  @when as_written || (mask_strength > 0 || sampling != "Continuous") && (mask_type == "Staggered cells" || mask_type == "Slot mask")
                                    // @help "Vertical offset of every other column of cells or slots. 0.5 breaks up rows as real tubes do, 0 aligns them."
uniform float mask_border = 0.8;    // @range 0 1  @limit 0 1  @label "Border darkness"  @group "Mask"  @when as_written || mask_strength > 0
                                    // @help "How dark the mask is between stripes. 0 removes the borders. In dot triads, higher values make the dots smaller."
uniform float mask_strength = 1.0;  // @range 0 1  @limit 0 1  @label "Strength"  @group "Mask"  @identity 0  @when !as_written  @photo amount
                                    // @help "0 turns the mask off. At 1, each stripe shows only its own colour."
uniform float brightness_kept = 1.0;  // @range 0 1  @limit 0 1  @label "Brightness compensation"  @group "Mask"  @when !as_written && (mask_strength > 0 || scanline_strength > 0)
                                      // @help "1 brightens stripes and scanlines until the mean is unchanged. Light above white is clipped. 0 only removes light. The article's factor 3 makes up for the stripes but not for their borders, which keep 54 % at a border darkness of 0.8."
uniform int subpixel_order = 0;     // @items "RGB" "BGR"  @items_was "Red, green, blue" "Blue, green, red"  @label "Subpixel order"  @group "Mask"  @when !as_written && mask_strength > 0 && monochrome < 1
                                    // @help "Order of the colours in a cell, from left to right."
uniform int sampling = 1;           // @items "Cell centre" "Cell average" "Continuous"  @items_was "Middle of the cell" "Mean of the cell" "Unbroken"  @label "Sampling"  @group "Mask"  @when !as_written  @photo start 2
                                    // @help "Cell centre and Cell average give each cell one colour of the picture. Continuous shows the unbroken picture behind the mask. Real tubes do the same, as their beams don't light one cell at a time."

uniform vec2 red_offset = vec2(-2.0, 0.0);   // @range -8 8  @limit -64 64  @label "Red offset"  @unit "px"  @group "Convergence"  @identity 0  @photo start 0
                                             // @help "Where red is sampled, to the right and up. 0 leaves it in place."
uniform vec2 green_offset = vec2(2.0, 0.0);  // @range -8 8  @limit -64 64  @label "Green offset"  @unit "px"  @group "Convergence"  @identity 0  @photo start 0
                                             // @help "Where green is sampled, to the right and up. An offset against red and blue gives green and magenta fringes."
uniform vec2 blue_offset = vec2(-2.0, 0.0);  // @range -8 8  @limit -64 64  @label "Blue offset"  @unit "px"  @group "Convergence"  @identity 0  @photo start 0
                                             // @help "Where blue is sampled, to the right and up. 0 leaves it in place."

uniform float monochrome = 0.0;              // @range 0 1  @limit 0 1  @label "Monochrome"  @group "Tint"  @identity 0  @when !as_written
                                             // @help "0 is full colour. At 1, only brightness is left and the mask no longer separates colours, as on a tube with one phosphor."
uniform vec3 tint = vec3(1.0);               // @color  @label "Tint"  @group "Tint"  @identity 1  @when !as_written
                                             // @help "Colour of the phosphor. The light is multiplied by it. White leaves it unchanged."

uniform float scanline_strength = 0.0;  // @range 0 1  @limit 0 1  @label "Strength"  @group "Scanlines"  @identity 0  @when !as_written  @photo amount
                                        // @help "Depth of the scanlines: the fraction of the light that is lost between them. 0 turns them off."
uniform int scanline_unit = 0;          // @items "Pixels" "Source lines"  @label "Period unit"  @group "Scanlines"  @when !as_written && scanline_strength > 0
                                        // @help "Unit of the scanline period. With Source lines, each line of the source gets its own scanline, wherever the source is placed in the picture. Vertical scanlines follow its columns."
uniform float scanline_period = 4.0;    // @range 2 16  @limit 1 1000  @label "Period"  @unit "px per period"  @group "Scanlines"  @period "$scanline_unit == 0 ? $scanline_period : 0"  @when !as_written && scanline_strength > 0 && scanline_unit == "Pixels"  @photo lines
                                        // @help "Distance between scanlines, in pixels. It doesn't scale with the render size."
uniform float scanline_lines = 1.0;     // @range 0.5 4  @limit 0.25 64  @label "Lines per scanline"  @group "Scanlines"  @period "$scanline_unit == 0 ? 0 : $picture_size * $scanline_lines * ($scanline_axis == 0 ? $LINE : $COLUMN) * (1 + ($scanline_interlace == 2) + ($scanline_interlace == 1) * (($scanline_axis == 0 ? $LINES : $COLUMNS) > 288) * (($scanline_axis == 0 ? $LINES : $COLUMNS) <= 576))"  @when !as_written && scanline_strength > 0 && scanline_unit == "Source lines"  @photo lines
                                        // @help "Number of source lines that each scanline covers. Only used when Period unit is Source lines."
uniform int scanline_interlace = 1;     // @items "Off" "Auto" "On"  @label "Interlacing"  @group "Scanlines"  @when !as_written && scanline_strength > 0 && scanline_unit == "Source lines"
                                        // @help "Draws even and odd source lines in alternating fields, 60 fields per second. Auto does this for sources of 289 to 576 lines. Only used when Period unit is Source lines."
uniform int scanline_axis = 0;          // @items "Horizontal" "Vertical"  @items_was "Across" "Up and down"  @label "Direction"  @group "Scanlines"  @when !as_written && scanline_strength > 0
                                        // @help "Direction of the scanlines."

uniform float vignette = 0.4;        // @range 0.05 2  @limit 0.01 10  @label "Exponent"  @group "Vignette"  @when as_written || vignette_depth > 0
                                     // @help "Shape of the dark edges. A small exponent darkens only the rim, a large one reaches far into the picture."
uniform float vignette_depth = 0.6;  // @range 0 1  @limit 0 1  @label "Depth"  @group "Vignette"  @identity 0  @when !as_written  @photo start 0
                                     // @help "How much light is lost at the very edges. 0 turns the vignette off. 1 is the article's, with black edges."

uniform float pulse_intensity = 0.03;  // @range 0 0.05  @limit 0 0.05  @label "Intensity"  @group "Pulse"  @identity 0  @photo start 0
                                       // @help "Strength of the brightness waves that move across the screen. 0 turns them off. The range is small, as strong waves above three per second can harm photosensitive viewers."
uniform float pulse_width = 60.0;      // @range 10 400  @limit 1 10000  @label "Wave width"  @unit "px/rad"  @group "Pulse"  @when pulse_intensity > 0
                                       // @help "Width of one radian of the wave. A whole wave is 6.28 times as long."
uniform float pulse_rate = 20.0;       // @range 0 40  @limit 0 200  @label "Rate"  @unit "rad/s"  @group "Pulse"  @when pulse_intensity > 0
                                       // @help "Speed of the waves. 20 is 3.18 waves per second, just fast enough to harm photosensitive viewers. 0 stops them."

uniform float picture_size = 1.0;  // @range 0.8 1.1  @limit 0.1 10  @label "Picture size"  @group "Glass"  @identity 1  @when !as_written
                                   // @help "Size of the picture on the glass. Below 1, a dark rim surrounds it. Above 1, its edges are cut off, as on television sets (overscan)."

// Included here, because the panel lists parameters in declaration order and the mask's come first.
#include "glass_settings.glsl"
#include "as_written.glsl"
#include "tube_as_written.glsl"

in vec2 uv;
out vec4 color;

// Distance from one red to the next, px.
float mask_pitch() {
    float pitch = mask_unit == 0 ? mask_size : u_resolution.x / mask_triads;
    return mask_snap ? max(floor(pitch + 0.5), 1.0) : pitch;
}

// The position in the picture, 0..1, that the beam draws at a position on the tube.
vec2 picture_place(vec2 px) {
    vec2 place = px / u_resolution;
    return picture_size == 1.0 ? place : (place - 0.5) / picture_size + 0.5;
}

vec3 scene_at(vec2 px, float level) {
    return textureLod(scene, picture_place(px), level).rgb;
}

// The picture's light at a position on the tube. `level` is the mipmap level.
vec3 scene_light(vec2 px, float level) {
    return vec3(scene_at(px + red_offset, level).r, scene_at(px + green_offset, level).g,
                scene_at(px + blue_offset, level).b);
}

vec3 picture_light(Mask mask, vec2 px) {
    vec3 light;
    if (sampling == 2) {
        light = scene_light(px, 0.0);
    } else {
        float texels = mask.pitch * u_source_resolution.x / u_resolution.x;
        light = scene_light(mask_cell_centre(mask, px), sampling == 1 ? log2(max(texels, 1.0)) : 0.0);
    }
    return mix(light, vec3(luminance(light)), monochrome) * tint;
}

// The mask and its brightness compensation. A single phosphor has no stripes, only borders.
vec3 through_mask(Mask mask, vec2 px, float pixel) {
    vec3 open = mask_light(mask, px, pixel);
    if (subpixel_order == 1)
        open = open.bgr;
    open = mix(open, vec3((open.r + open.g + open.b) / 3.0), monochrome);
    float visible = mask_strength * mask_visibility(mask.pitch, pixel);
    float peak = mask_peak(mask) * mix(1.0, 1.0 / 3.0, monochrome);
    float bare = 1.0 / mix(1.0, max(peak, 1.0), visible);
    return mix(vec3(1.0), open, mask_strength) * mix(bare, 1.0, brightness_kept);
}

// 1 where the beam draws the picture, 0 beyond its edges.
float drawn_part(vec2 place) {
    vec2 half_size = u_resolution / u_resolution.y;
    return picture_size < 1.0 ? glass_coverage(place / picture_size, half_size, 0.0) : 1.0;
}

float source_scanlines(vec2 px) {
    bool is_across = scanline_axis == 0;
    vec3 lines = is_across ? u_source_lines : u_source_columns;
    vec2 place = picture_place(px);
    float line = ((is_across ? 1.0 - place.y : place.x) - lines.x) / lines.y;
    float length_px = (is_across ? u_resolution.y : u_resolution.x) * picture_size;
    float field = is_interlaced(scanline_interlace, lines.z) ? field_at(u_time) : -1.0;
    return source_scanline_factor(line, scanline_lines, lines.y * length_px, field,
                                  scanline_strength);
}

float scanlines(vec2 px) {
    float across = scanline_axis == 0 ? px.y : px.x;
    float factor = scanline_unit == 0
                       ? scanline_factor(across, scanline_period, scanline_strength)
                       : source_scanlines(px);
    return factor / mix(1.0, 1.0 - 0.5 * scanline_strength, brightness_kept);
}

float vignette_left(vec2 place) {
    vec2 edge = max(1.0 - place * place, 0.0);
    return mix(1.0, pow(edge.x * edge.y, vignette), vignette_depth);
}

// The wave averaged over the frame, which ends at u_time.
float pulse(float x) {
    float turns = pulse_rate * u_time_delta / 6.28318530718;
    float angle = x / pulse_width + pulse_rate * (u_time - 0.5 * u_time_delta);
    return 1.0 + pulse_intensity * cos(angle) * sinc(turns);
}

void main() {
    vec2 place = barrel_radial(2.0 * uv - 1.0, curvature);
    vec2 px = (0.5 * place + 0.5) * u_resolution;
    if (as_written) {
        CellsAsWritten cells = cells_as_written(px, mask_pitch(), mask_border, mask_stagger);
        vec3 light = vec3(texture(scene, (cells.corner + red_offset) / u_resolution).r,
                          texture(scene, (cells.corner + green_offset) / u_resolution).g,
                          texture(scene, (cells.corner + blue_offset) / u_resolution).b);
        light = srgb_encode_unbounded(light) * cells.mask;
        vec2 edge = max(1.0 - place * place, 0.0);
        light *= pow(edge.x * edge.y, vignette);
        light *= 1.0 + pulse_intensity * cos(px.x / pulse_width + u_time * pulse_rate);
        color = vec4(light, 1.0);
        return;
    }
    float pixel = 0.5 * (abs(dFdx(px.x)) + abs(dFdy(px.y)));
    Mask mask = Mask(mask_type, mask_pitch(), cell_height, mask_border, mask_stagger);
    vec3 light = picture_light(mask, px) * through_mask(mask, px, pixel);
    light *= scanlines(px) * drawn_part(place);
    color = vec4(light * vignette_left(place) * pulse(px.x), 1.0);
}
