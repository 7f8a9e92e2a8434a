#version 410 core
// Components: luma and the two colour difference signals of each line, four samples per cycle of the
// subcarrier. Reads display values.
#include "signal_settings.glsl"

uniform sampler2D picture;
uniform vec2 u_resolution;

out vec4 color;

const int samples = 4;  // per sample of the signal

void main() {
    vec3 lines = signal_lines();
    float line = floor(gl_FragCoord.y);
    if (line >= lines.z) {
        color = vec4(0.0);
        return;
    }
    float y = 1.0 - lines.x - (line + 0.5) * lines.y;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < samples; ++i) {
        float x = (gl_FragCoord.x - 0.5 + (float(i) + 0.5) / float(samples)) / u_resolution.x;
        sum += texture(picture, vec2(x, y)).rgb;
    }
    color = vec4(yuv_of(sum / float(samples)), 1.0);
}
