#version 410 core
// Composite: what the eye gets of the phosphor. Light and bloom are added in linear light, tone
// mapped once, seen through the glass, and display-encoded at the end.
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

uniform float bloom_intensity = 0.6;  // @range 0 3  @limit 0 100  @label "Intensity"  @group "Bloom"  @identity 0
                                      // @help "How much of the spread light is added to the trace."
uniform float exposure = 1.5;         // @range 0.1 16  @limit 0 1000  @scale log  @label "Exposure"  @group "Exposure"
                                      // @help "Brightness of the whole trace, like a camera's exposure: twice as much doubles the light before the tone map."
uniform int tone_map = 1;             // @items "Clamp" "Reinhard" "ACES"  @label "Tone map"  @group "Exposure"
                                      // @help "How light brighter than the screen can show is brought back to it. Clamp cuts it off, the others bend it softly."
uniform float white = 0.0;            // @range 0 16  @limit 0 1000  @label "White"  @group "Exposure"  @identity 0
                                      // @help "The light that Reinhard turns to full white. 0 is without: everything stays a little below it."
uniform float keep_hue = 0.8;         // @range 0 1  @limit 0 1  @label "Keep hue"  @group "Exposure"
                                      // @help "0: a very bright trace turns white, as on film. 1: it stays as coloured as the phosphor, as to the eye."
uniform bool display_encode = true;   // @label "Display encoding"  @group "Exposure"
                                      // @help "Light becomes screen values by the sRGB curve, so that twice the light looks like it. Off shows the bare numbers: darker, with more contrast."
uniform bool dither = true;           // @label "Dither"  @group "Exposure"  @identity 0
                                      // @help "Noise of half a screen step, so that soft glows show no bands."
uniform float aberration = 1.0;       // @range 0 8  @limit -64 64  @label "Aberration"  @unit "px"  @group "Glass"  @identity 0
                                      // @help "Colour fringes of a cheap lens: red is read this far to the right and blue to the left, green stays."
uniform float scanline_strength = 0.3;   // @range 0 1  @limit 0 1  @label "Scanlines"  @group "Glass"  @identity 0
                                         // @help "Depth of the horizontal stripes. The mean brightness becomes 1 - strength / 2."
uniform float scanline_period = 4.0;     // @range 2 16  @limit 1 1000  @label "Scanline period"  @unit "px a period"  @group "Glass"
                                         // @help "Distance from stripe to stripe in pixels of the picture, whatever its size."
uniform float curvature = 0.04;          // @range 0 0.3  @limit 0 2  @label "Curvature"  @group "Glass"  @identity 0
                                         // @help "How much the glass bulges towards you."
uniform float corner_radius = 0.03;      // @range 0 0.5  @limit 0 1  @label "Corner radius"  @unit "half heights"  @group "Glass"  @identity 0
                                         // @help "How round the corners of the glass are. 1 is as round as the picture is high."
uniform float vignette = 0.3;            // @range 0 1  @limit 0 2  @label "Vignette"  @group "Glass"  @identity 0
                                         // @help "How much of the light is lost in the corners."
uniform vec3 ambient_glass = vec3(0.0, 0.003, 0.0);  // @color  @label "Ambient glass"  @group "Glass"
                                                     // @help "Light of the room that the glass gives back, so that its black is not quite black."

in vec2 uv;
out vec4 color;

// Where nothing bends or shifts the picture each pixel is its own texel, to the last digit.
bool is_straight() {
    return curvature == 0.0 && aberration == 0.0 && textureSize(phosphor, 0) == ivec2(u_resolution);
}

vec3 light_at(vec2 at) {
    return light_of(kept_light(phosphor, at)) + bloom_intensity * colored(texture(bloom, at).rgb);
}

// Red and blue from either side: aberration / width of the picture, as a lens that bends them apart.
vec3 fringed_light(vec2 at) {
    if (is_straight())
        return light_of(kept_texel(phosphor, ivec2(gl_FragCoord.xy))) +
               bloom_intensity * colored(texture(bloom, at).rgb);
    // Without aberration compilers see that all three are one reading.
    vec2 shift = aberration == 0.0 ? vec2(0.0) : vec2(aberration / u_resolution.x, 0.0);
    return vec3(light_at(at + shift).r, light_at(at).g, light_at(at - shift).b);
}

// Light kept by tone_map_every_frame has been tone mapped already.
vec3 shown(vec3 light) {
    if (tone_map_every_frame)
        return clamp(light, 0.0, 1.0);
    vec3 exposed = light * exposure;
    vec3 brightest = vec3(brightest_channel(exposed));
    float most = tone_mapped_per_channel(brightest, tone_map, white).r;
    return mix(tone_mapped_per_channel(exposed, tone_map, white), with_brightest(exposed, most),
               keep_hue);
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
    vec3 display = display_encode ? srgb_encode(light) : light;
    color = vec4(dither ? dithered(display, uvec2(gl_FragCoord.xy), uint(u_frame)) : display, 1.0);
}
