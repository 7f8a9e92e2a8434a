#version 410 core
// Line: the light along each line, drawn with the spot's horizontal size. Linear light.
#include "raster_settings.glsl"

uniform sampler2D video;
uniform vec2 u_output_resolution;

in vec2 uv;
out vec4 color;

const int reach = 5;            // samples to each side
const float largest_size = 1.7;  // of the spot, in samples: a third of the reach

void main() {
    int line = int(gl_FragCoord.y);
    if (float(line) >= raster().lines) {
        color = vec4(0.0);
        return;
    }
    int count = textureSize(video, 0).x;
    // Line of 240 and pixel of the picture, in samples.
    float unit = float(count) * u_output_resolution.y / u_output_resolution.x / 240.0;
    float at = uv.x * float(count);
    int middle = int(floor(at));
    vec3 light = vec3(0.0);
    for (int i = middle - reach; i <= middle + reach; ++i) {
        if (i < 0 || i >= count)
            continue;
        vec3 current = texelFetch(video, ivec2(i, line), 0).rgb;
        vec3 size = min(unit * spot_size(current, spot, spot_growth), largest_size);
        light += current * spot_light(vec3(at - float(i) - 0.5), size, 1.0);  // a sample lasts for 1
    }
    color = vec4(light, 1.0);
}
