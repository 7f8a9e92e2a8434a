#version 410 core
// Composite: the picture on the screen. Light and bloom are added in linear light and tone mapped
// once. The effects of the glass follow, and display encoding at the end.
#include "as_written.glsl"
#include "color.glsl"
#include "composite_as_written.glsl"
#include "glass.glsl"
#include "graticule_light.glsl"
#include "kept_light.glsl"
#include "noise.glsl"
#include "one_color.glsl"
#include "tone_map_every_frame.glsl"
#include "tonemap.glsl"

uniform sampler2D phosphor;
uniform sampler2D bloom;
uniform vec2 u_resolution;
uniform int u_frame;
uniform float u_peak;

uniform float bloom_intensity = 0.6;  // @range 0 3  @limit 0 100  @label "Intensity"  @group "Bloom"  @identity 0  @photo amount
                                      // @help "How much of the blurred light is added to the trace. 0 turns the bloom off."
uniform float exposure = 1.5;         // @range 0.1 16  @limit 0 1000  @scale log  @label "Exposure"  @group "Tone mapping"  @when !tone_map_every_frame
                                      // @help "Brightness of the whole trace, before tone mapping. Doubling it doubles the light."
uniform int tone_map = 1;             // @items "Clamp" "Reinhard" "ACES"  @label "Tone map"  @group "Tone mapping"  @when !as_written && !tone_map_every_frame
                                      // @help "How light brighter than the display is mapped to its range. Clamp cuts it off. Reinhard and ACES compress it softly."
uniform float white = 0.0;            // @range 0 16  @limit 0 1000  @label "White point"  @group "Tone mapping"  @identity 0  @when !as_written && !tone_map_every_frame && tone_map == "Reinhard"
                                      // @help "Light that Reinhard maps to full white. 0 turns it off, so everything stays slightly below white."
uniform float keep_hue = 0.8;         // @range 0 1  @limit 0 1  @label "Preserve hue"  @group "Tone mapping"  @when !as_written && !tone_map_every_frame
                                      // @help "0 lets a very bright trace turn white, as on film. 1 keeps the phosphor's hue, as the eye sees it."
uniform bool display_encode = true;   // @label "sRGB encoding"  @group "Tone mapping"  @when !as_written
                                      // @help "Encodes linear light with the sRGB curve for the display. Off shows the linear values directly, which is darker with more contrast."
uniform bool dither = true;           // @label "Dither"  @group "Tone mapping"  @identity 0  @when !as_written
                                      // @help "Adds noise of half an 8-bit level, so that soft glows don't show bands."
uniform float aberration = 1.0;       // @range 0 8  @limit -64 64  @label "Chromatic aberration"  @unit "px"  @group "Glass"  @identity 0
                                      // @help "Colour fringes of a cheap lens. Red is sampled this far to the right, blue this far to the left. Green stays in place. 0 turns it off."
uniform float scanline_strength = 0.3;   // @range 0 1  @limit 0 1  @label "Scanline strength"  @group "Glass"  @identity 0  @photo off
                                         // @help "Depth of the horizontal scanlines. The mean brightness becomes 1 - strength / 2. 0 turns them off."
uniform float scanline_period = 4.0;     // @range 2 16  @limit 1 1000  @label "Scanline period"  @unit "px per period"  @group "Glass"  @when scanline_strength > 0
                                         // @help "Distance between scanlines, in pixels. It doesn't scale with the render size."
uniform float curvature = 0.04;          // @range 0 0.3  @limit 0 2  @label "Curvature"  @group "Glass"  @identity 0
                                         // @help "How far the glass bulges towards the viewer. 0 is flat."
uniform float corner_radius = 0.03;      // @range 0 0.5  @limit 0 1  @label "Corner radius"  @unit "× half height"  @group "Glass"  @identity 0  @when !as_written
                                         // @help "Corner radius of the glass. 0 gives square corners, 1 equals half the picture height."
uniform float vignette = 0.3;            // @range 0 1  @limit 0 2  @label "Vignette"  @group "Glass"  @identity 0
                                         // @help "How much light is lost in the corners. 0 turns the vignette off, 1 makes the corners black."
uniform vec3 ambient_glass = vec3(0.0, 0.003, 0.0);  // @color  @label "Ambient light"  @group "Glass"
                                                     // @help "Room light that the glass reflects. It lifts the black level. Black turns it off."

in vec2 uv;
out vec4 color;

// True if nothing bends or shifts the picture. Each pixel is then exactly its own texel.
bool is_straight() {
    return curvature == 0.0 && aberration == 0.0 && textureSize(phosphor, 0) == ivec2(u_resolution);
}

vec3 light_at(vec2 at) {
    return light_of(kept_light(phosphor, at)) + bloom_intensity * colored(texture(bloom, at).rgb);
}

// Red and blue are sampled on opposite sides, aberration / width of the picture away, as a lens
// refracts them differently.
vec3 fringed_light(vec2 at) {
    if (is_straight())
        return light_of(kept_texel(phosphor, ivec2(gl_FragCoord.xy))) +
               bloom_intensity * colored(texture(bloom, at).rgb);
    // Without aberration, compilers merge the three samples into one.
    vec2 shift = aberration == 0.0 ? vec2(0.0) : vec2(aberration / u_resolution.x, 0.0);
    return vec3(light_at(at + shift).r, light_at(at).g, light_at(at - shift).b);
}

// Light stored with tone_map_every_frame is already tone mapped.
vec3 shown(vec3 light) {
    if (tone_map_every_frame)
        return clamp(light, 0.0, 1.0);
    vec3 exposed = light * exposure;
    vec3 brightest = vec3(brightest_channel(exposed));
    float most = tone_mapped_per_channel_to(brightest, tone_map, white, u_peak).r;
    return mix(tone_mapped_per_channel_to(exposed, tone_map, white, u_peak),
               with_brightest(exposed, most), keep_hue);
}

vec3 through_glass(vec3 light, vec2 place) {
    float y_px = 0.5 * (place.y + 1.0) * u_resolution.y;
    light = shown(light);
    light *= scanline_factor(y_px, scanline_period, scanline_strength);
    light = with_graticule(light + ambient_glass, place, u_resolution);
    light *= vignette_factor(place, vignette);
    if (curvature == 0.0 && corner_radius == 0.0)
        return light;
    vec2 half_size = u_resolution / u_resolution.y;
    return light * glass_coverage(place, half_size, corner_radius);
}

vec3 as_the_article_wrote(vec3 light, vec2 place) {
    if (any(greaterThan(abs(place), vec2(1.0))))
        return vec3(0.0);
    vec2 at = 0.5 * place + 0.5;
    if (!tone_map_every_frame)
        light = reinhard(light * exposure);
    light *= scanline_as_written(at.y * u_resolution.y, scanline_period, scanline_strength);
    light *= graticule_as_written(at, vec2(graticule_divisions), graticule);
    return light * vignette_as_written(place, vignette) + ambient_glass;
}

void main() {
    vec2 place = barrel(2.0 * uv - 1.0, curvature);
    vec3 fringed = fringed_light(0.5 * place + 0.5);
    if (as_written) {
        color = vec4(as_the_article_wrote(fringed, place), 1.0);
        return;
    }
    vec3 light = through_glass(fringed, place);
    vec3 display = display_encode ? srgb_encode_to(light, u_peak) : light;
    color = vec4(dither ? dithered(display, uvec2(gl_FragCoord.xy), uint(u_frame)) : display, 1.0);
}
