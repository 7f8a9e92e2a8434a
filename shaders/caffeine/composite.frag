#version 410 core
// Composite: the mean of all paths, exposed, tone mapped once and display-encoded.
#include "as_written.glsl"
#include "color.glsl"
#include "noise.glsl"
#include "tonemap.glsl"

uniform sampler2D sum;      // linear light; alpha: number of samples
uniform sampler2D article;  // the same with the article's method
uniform float u_peak;

uniform float exposure = 1.0;    // @range 0.1 10  @limit 0 1000  @scale log  @label "Exposure"  @group "Tone mapping"  @identity 1  @when !as_written
                                 // @help "Brightness of the whole picture, before tone mapping. Changing it keeps the samples."
uniform int tone_map = 2;        // @items "Clamp" "Reinhard" "ACES"  @label "Tone map"  @group "Tone mapping"  @when !as_written
                                 // @help "How light brighter than the display is mapped to its range. Clamp cuts it off. Reinhard and ACES compress it softly."
uniform float white = 0.0;       // @range 0 16  @limit 0 1000  @label "White point"  @group "Tone mapping"  @identity 0  @when !as_written && tone_map == "Reinhard"
                                 // @help "Light that Reinhard maps to full white. 0 turns it off, so everything stays slightly below white."
uniform float article_gamma = 2.2;  // @range 1 3  @limit 0.1 10  @label "Article gamma"  @group "Article"  @when as_written
                                    // @help "Gamma of the article's display curve, which replaces sRGB. Only used with Original article."
uniform bool dither = true;      // @label "Dither"  @group "Tone mapping"  @identity 0
                                 // @help "Adds noise of half an 8-bit level, so that soft shadows don't show bands."

out vec4 color;

vec3 mean_of(sampler2D sums) {
    vec4 texel = texelFetch(sums, ivec2(gl_FragCoord.xy), 0);
    return texel.rgb / max(texel.a, 1.0);
}

void main() {
    // The article clamps and applies a plain gamma instead of the display's sRGB curve.
    vec3 light = tone_mapped_per_channel_to(exposure * mean_of(sum), tone_map, white, u_peak);
    vec3 display = as_written ? pow(clamp(mean_of(article), 0.0, 1.0), vec3(1.0 / article_gamma))
                              : srgb_encode_to(light, u_peak);
    color = vec4(dither ? dithered(display, uvec2(gl_FragCoord.xy), 0u) : display, 1.0);
}
