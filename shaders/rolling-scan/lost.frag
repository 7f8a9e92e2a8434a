#version 410 core
// Lost light: the part of the light that does not fit into the sub-frames, in percent. Reads linear
// light. Measures 64 x 36 places.

uniform sampler2D picture;
uniform float u_peak;

uniform int scan = 0;
uniform float brightness = 0.7;

out vec4 color;

void main() {
    const ivec2 places = ivec2(64, 36);
    float wanted = 0.0;
    float lost = 0.0;
    for (int y = 0; y < places.y; ++y)
        for (int x = 0; x < places.x; ++x) {
            vec2 place = (vec2(x, y) + 0.5) / vec2(places);
            vec3 light = max(textureLod(picture, place, 0.0).rgb, 0.0) * (scan < 2 ? brightness : 1.0);
            wanted += dot(light, vec3(1.0));
            lost += dot(max(light - u_peak, 0.0), vec3(1.0));
        }
    color = vec4(100.0 * lost / max(wanted, 1e-6), 0.0, 0.0, 1.0);
}
