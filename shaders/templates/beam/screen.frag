#version 410 core
// Screen: the colours of both layers and the glow, with one tone map. Writes display values.
#include "color.glsl"
#include "decay.glsl"
#include "tonemap.glsl"

uniform sampler2D phosphor;  // stored light. Red: flash, green: afterglow
uniform sampler2D glow;
uniform vec3 flash_color = vec3(0.3, 0.5, 1.0);      // @color  @label "Flash"  @group "Phosphor"
uniform vec3 afterglow_color = vec3(0.7, 1.0, 0.1);  // @color  @label "Afterglow"  @group "Phosphor"
uniform float glow_amount = 0.4;                     // @range 0 2  @limit 0 100  @label "Amount"  @group "Glow"  @identity 0
                                                     // @help "Light that the glass scatters around the lines."
uniform float exposure = 2.0;                        // @range 0.1 32  @limit 0 1000  @scale log  @label "Exposure"  @group "Picture"  @identity 1
                                                     // @help "Brightness of the whole picture. Doubling it doubles the light."

in vec2 uv;
out vec4 color;

void main() {
    vec2 stored = texture(phosphor, uv).rg + glow_amount * texture(glow, uv).rg;
    vec2 emitted = stored * emitted_share();
    vec3 light = exposure * (emitted.r * flash_color + emitted.g * afterglow_color);
    color = vec4(srgb_encode(tone_mapped_keeping_hue(light, tone_map_aces, 0.0)), 1.0);
}
