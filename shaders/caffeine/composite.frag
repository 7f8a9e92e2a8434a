#version 410 core
// Composite: the mean of all paths, exposed, tone mapped and display-encoded, once.
#include "as_written.glsl"
#include "color.glsl"
#include "noise.glsl"
#include "tonemap.glsl"

uniform sampler2D sum;      // linear light; alpha: of how many samples
uniform sampler2D article;  // the same, by the article's method

uniform float exposure = 1.0;    // @range 0.1 10  @limit 0 1000  @scale log  @label "Exposure"  @group "Picture"  @identity 1
                                 // @help "Brightness of the whole picture, like a camera's exposure. The samples stay."
uniform int tone_map = 2;        // @items "Clamp" "Reinhard" "ACES"  @label "Tone map"  @group "Picture"
                                 // @help "How light brighter than the screen can show is brought back to it. Clamp cuts it off, the others bend it softly."
uniform float white = 0.0;       // @range 0 16  @limit 0 1000  @label "White"  @group "Picture"  @identity 0
                                 // @help "The light that Reinhard turns to full white. 0 is without."
uniform float article_gamma = 2.2;  // @range 1 3  @limit 0.1 10  @label "Article's gamma"  @group "Article"
                                    // @help "The article's display curve, in place of the display's own. Only as the article wrote it."
uniform bool dither = true;      // @label "Dither"  @group "Picture"  @identity 0
                                 // @help "Noise of half a screen step, so that soft shadows show no bands."

out vec4 color;

vec3 mean_of(sampler2D sums) {
    vec4 texel = texelFetch(sums, ivec2(gl_FragCoord.xy), 0);
    return texel.rgb / max(texel.a, 1.0);
}

void main() {
    // The article clamps and takes the root, which is not the display's curve.
    vec3 light = tone_mapped_per_channel(exposure * mean_of(sum), tone_map, white);
    vec3 display = as_written ? pow(clamp(mean_of(article), 0.0, 1.0), vec3(1.0 / article_gamma))
                              : srgb_encode(light);
    color = vec4(dither ? dithered(display, uvec2(gl_FragCoord.xy), 0u) : display, 1.0);
}
