#version 410 core
// Picture: the decoded lines in the size of the picture. Display values.
#include "noise.glsl"
#include "signal_settings.glsl"

uniform sampler2D decoded;
uniform int u_frame;

uniform bool dither = true;  // @label "Dither"  @group "Receiver"  @identity 0
                             // @help "Adds noise of half an 8-bit level, so that soft glows don't show bands."

in vec2 uv;
out vec4 color;

void main() {
    vec3 lines = signal_lines();
    float line = floor((1.0 - uv.y - lines.x) / lines.y);
    if (line < 0.0 || line >= lines.z) {
        color = vec4(0.0, 0.0, 0.0, 1.0);
        return;
    }
    float row = (line + 0.5) / float(textureSize(decoded, 0).y);
    vec3 display = max(texture(decoded, vec2(uv.x, row)).rgb, 0.0);
    color = vec4(dither ? dithered(display, uvec2(gl_FragCoord.xy), uint(u_frame)) : display, 1.0);
}
