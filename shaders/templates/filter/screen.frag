#version 410 core
// Screen: each line of the source is drawn by a beam, behind stripes of red, green and blue.
// Reads linear light. Writes display values, because it is the last pass.
#include "color.glsl"
#include "tonemap.glsl"

uniform sampler2D image;      // the source
uniform sampler2D glow;       // what the pass "glow" drew in this frame
uniform vec3 u_source_lines;  // of the source: start from the top, distance, number

// A uniform is a slider. Its default is GLSL's own; the comment sets range, label and help.
uniform int line_source = 0;       // @items "Lines of the source" "Fixed number"  @label "Follow"  @group "Scanlines"
                                   // @help "Lines of the source draws one scanline for each of its lines. Fixed number suits sources with many lines."
uniform float line_count = 240.0;  // @range 120 720 1  @limit 1 10000  @label "Number of lines"  @group "Scanlines"  @when line_source == "Fixed number"
                                   // @help "Scanlines from top to bottom."
uniform float beam_width = 0.5;    // @range 0.2 1  @limit 0.05 2  @label "Beam width"  @unit "× line distance"  @group "Scanlines"
                                   // @help "Width of a dark line at half of its brightness. Narrow beams leave dark gaps."
uniform float beam_growth = 0.5;   // @range 0 1  @limit 0 2  @label "Growth with brightness"  @group "Scanlines"  @identity 0
                                   // @help "How much wider a bright line is, because a stronger beam spreads. Highlights then close their gaps."
uniform float stripe_pitch = 3.0;  // @range 2 12  @limit 2 100  @label "Period"  @unit "px per period"  @group "Mask"
                                   // @help "Distance from one red stripe to the next."
uniform float stripe_depth = 0.5;  // @range 0 1  @limit 0 1  @label "Depth"  @group "Mask"  @identity 0
                                   // @help "How much each stripe blocks the other two colours. 0 turns the mask off."
uniform float glow_amount = 0.25;  // @range 0 1  @limit 0 10  @label "Amount"  @group "Glow"  @identity 0
                                   // @help "Light that the glass scatters around bright parts."
uniform float exposure = 1.3;      // @range 0.25 4  @limit 0 1000  @scale log  @label "Exposure"  @group "Picture"  @identity 1
                                   // @help "Brightness of the whole picture. Doubling it doubles the light."

in vec2 uv;
out vec4 color;

const float two_pi = 6.28318530718;

// Light of one scanline at a distance, in line distances. The profile is a Gaussian whose integral
// is 1, so a wider beam is dimmer and the picture keeps its mean. `pixel` is the height of a pixel:
// averaged over it, lines that are finer than pixels fade instead of causing moiré.
vec3 beam(vec3 light, float away, float pixel) {
    const float sigma_of_width = 0.42466;  // 1 / (2 sqrt(2 ln 2))
    vec3 width = beam_width * (1.0 + beam_growth * clamp(light, 0.0, 1.0));
    vec3 variance = sigma_of_width * width * sigma_of_width * width + pixel * pixel / 12.0;
    return light * exp(-0.5 * away * away / variance) * inversesqrt(two_pi * variance);
}

vec3 scanlines() {
    bool is_fixed = line_source == 1;
    float start = is_fixed ? 0.0 : u_source_lines.x;
    float height = is_fixed ? 1.0 / line_count : u_source_lines.y;
    float place = (1.0 - uv.y - start) / height;  // in lines from the top; centres are at 0.5
    float pixel = fwidth(place);
    vec3 sum = vec3(0.0);
    for (int i = -2; i <= 2; ++i) {
        float line = floor(place) + float(i) + 0.5;
        vec3 light = texture(image, vec2(uv.x, 1.0 - start - line * height)).rgb;
        sum += beam(light, place - line, pixel);
    }
    return sum;
}

// Three waves, a third of a period apart. The mean of each is 1, so the mask keeps the brightness.
vec3 stripes() {
    vec3 phase = gl_FragCoord.x / stripe_pitch - vec3(0.0, 1.0, 2.0) / 3.0;
    return 1.0 + stripe_depth * cos(two_pi * phase);
}

void main() {
    vec3 light = scanlines() * stripes() + glow_amount * texture(glow, uv).rgb;
    color = vec4(srgb_encode(tone_mapped_per_channel(exposure * light, tone_map_aces, 0.0)), 1.0);
}
