#version 410 core
// Screen: light and glow in the phosphor's colour, tone mapped once, display-encoded at the end.
#include "as_written.glsl"
#include "color.glsl"
#include "noise.glsl"
#include "tint.glsl"
#include "tonemap.glsl"

uniform sampler2D light;
uniform sampler2D glow;  // red: narrow, green: wide, blue and alpha: their hue
uniform int u_frame;
uniform float u_peak;

uniform vec3 beam_color = vec3(0.25, 1.0, 0.4);  // @color  @label "Beam colour"  @group "Beam"
                                                 // @help "Colour of the phosphor's light."
uniform float glow_amount = 0.35;      // @range 0 2  @limit 0 100  @label "Intensity"  @group "Glow"  @identity 0  @when !as_written  @photo amount
                                       // @help "How much scattered light is added around the lines. 0 turns the glow off."
uniform float glow_wide = 0.4;         // @range 0 1  @limit 0 1  @label "Wide mix"  @group "Glow"  @when !as_written && glow_amount > 0
                                       // @help "Fraction of the glow in the wide haze. 0 keeps all of it near the lines, 1 puts all of it in the haze."
uniform vec3 glow_color = vec3(1.0);   // @color  @label "Tint"  @group "Glow"  @when !as_written && glow_amount > 0
                                       // @help "Tint of the glow, relative to the beam colour. White leaves it unchanged."
uniform float exposure = 3.0;          // @range 0.1 16  @limit 0 1000  @scale log  @label "Exposure"  @group "Tone mapping"  @identity 1
                                       // @help "Brightness of the whole picture, before tone mapping. Doubling it doubles the light."
uniform int tone_map = 2;              // @items "Clamp" "Reinhard" "ACES" "Extended Reinhard" "AgX" "Khronos PBR Neutral" "None"  @items_was "" "" "" "" "" "Khronos neutral"  @label "Tone map"  @group "Tone mapping"  @identity 6  @when !as_written
                                       // @help "How light brighter than the display is mapped to its range. Clamp cuts it off, the others compress it softly. Extended Reinhard maps the white point to 1. ACES and AgX compress light as film does. Khronos PBR Neutral preserves colours up to 0.8. None passes the light on to the next look of a stack."
uniform float white = 4.0;             // @range 0.5 16  @limit 0.001 1000  @scale log  @label "White point"  @group "Tone mapping"  @when !as_written && tone_map == "Extended Reinhard"
                                       // @help "Light that Extended Reinhard maps to full white."
uniform float keep_hue = 0.6;          // @range 0 1  @limit 0 1  @label "Preserve hue"  @group "Tone mapping"  @identity 0  @when !as_written
                                       // @help "0 lets the brightest lines turn white, as on film. 1 keeps the phosphor's hue."
uniform vec3 background = vec3(0.0, 0.001, 0.0005);  // @color  @label "Background"  @group "Screen"  @when !as_written
                                                     // @help "Light of the dark screen. It lifts the black level. Black turns it off."
uniform bool dither = true;            // @label "Dither"  @group "Tone mapping"  @identity 0  @when !as_written
                                       // @help "Adds noise of half an 8-bit level, so that soft glows don't show bands."

in vec2 uv;
out vec4 color;

vec3 shown(vec3 light) {
    float peak = tone_map == tone_map_reinhard_to_white ? white : 0.0;
    return mix(tone_mapped_to(light, tone_map, peak, u_peak),
               tone_mapped_keeping_hue_to(light, tone_map, peak, u_peak), keep_hue);
}

// The hue interpolated between four texels, weighted by their light, as dark texels have no hue.
vec3 glow_color_at(vec2 hue) {
    if (hue == vec2(0.0))
        return vec3(1.0);
    vec2 part = fract(uv * vec2(textureSize(glow, 0)) - 0.5);
    vec4 weights = vec4(1.0 - part.x, part.x, part.x, 1.0 - part.x) *
                   vec4(part.yy, 1.0 - part.yy) *
                   (textureGather(glow, uv, 0) + textureGather(glow, uv, 1));
    float total = dot(weights, vec4(1.0));
    vec2 hues = vec2(dot(weights, textureGather(glow, uv, 2)),
                     dot(weights, textureGather(glow, uv, 3)));
    return color_of(total > 0.0 ? hues / total : hue);
}

void main() {
    vec3 direct = texture(light, uv).rgb;
    if (as_written) {
        color = vec4(srgb_encode(direct * exposure * beam_color), 1.0);
        return;
    }
    vec4 around = texture(glow, uv);
    vec3 scattered = glow_amount * mix(around.x, around.y, glow_wide) * glow_color_at(around.ba);
    vec3 linear = exposure * beam_color * (direct + scattered * glow_color);
    vec3 display = srgb_encode_to(shown(linear) + background, u_peak);
    color = vec4(dither ? dithered(display, uvec2(gl_FragCoord.xy), uint(u_frame)) : display, 1.0);
}
