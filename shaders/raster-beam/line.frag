#version 410 core
// Line: the light along each line, drawn with the spot's horizontal size. Linear light.
#include "raster_settings.glsl"

uniform sampler2D video;
uniform vec2 u_output_resolution;

in vec2 uv;
out vec4 color;

const float largest_size = 1.7;  // of the spot, in samples
const float deviations = 3.0;    // of the spot, that are drawn to each side: 99.7 % of its light

// The light of a sample, at a place along its line. A sample lasts for 1.
vec3 sample_light(int sample_at, int row, float at, float unit) {
    int last = textureSize(video, 0).x - 1;
    vec3 current = texelFetch(video, ivec2(clamp(sample_at, 0, last), row), 0).rgb;
    if (sample_at < 0 || sample_at > last)
        current = vec3(0.0);
    vec3 size = min(unit * spot_size(current, spot, spot_growth), largest_size);
    return current * spot_light(vec3(at - float(sample_at) - 0.5), size, 1.0);
}

void main() {
    int row = int(gl_FragCoord.y);
    if (float(row) >= raster().lines) {
        color = vec4(0.0);
        return;
    }
    float count = float(textureSize(video, 0).x);
    // Line of 240 and pixel of the picture, in samples.
    float unit = count * u_output_resolution.y / u_output_resolution.x / 240.0;
    float at = uv.x * count;
    int middle = int(floor(at));
    float widest = min(unit * spot_size(vec3(1.0), spot, spot_growth).g, largest_size);
    int reach = int(ceil(deviations * widest));
    vec3 light = vec3(0.0);
    int i = middle - reach;
    do {
        light += sample_light(i, row, at, unit);
        ++i;
    } while (i <= middle + reach);
    color = vec4(light, 1.0);
}
