#version 410 core
// Video: the signal of each line of the raster, one row per line of the field. Linear light. A gun
// that draws too far to the right gets its signal later.
#include "convergence_settings.glsl"
#include "raster_settings.glsl"

uniform sampler2D picture;
uniform vec2 u_resolution;
uniform vec2 u_output_resolution;

out vec4 color;

const int most_samples = 4;  // per signal sample, and per line

// The mean of the picture over a sample of the signal.
vec3 mean_at(float x, float y, float height) {
    // A line is within a row of the picture, or covers several.
    int rows = int(clamp(ceil(2.0 * height * float(textureSize(picture, 0).y)), 1.0, float(most_samples)));
    if (raster_lines == 0 && u_source_lines.z <= most_source_lines)
        rows = 1;
    vec3 sum = vec3(0.0);
    int row = 0;
    do {
        float down = y + ((float(row) + 0.5) / float(rows) - 0.5) * height;
        for (int i = 0; i < most_samples; ++i) {
            float across = x + ((float(i) + 0.5) / float(most_samples) - 0.5) / u_resolution.x;
            sum += texture(picture, vec2(across, 1.0 - down)).rgb;
        }
        ++row;
    } while (row < rows);
    return sum / float(rows * most_samples);
}

void main() {
    Raster drawn = raster();
    float line = floor(gl_FragCoord.y);
    if (line >= drawn.lines) {
        color = vec4(0.0);
        return;
    }
    float x = gl_FragCoord.x / u_resolution.x;
    float y = drawn.first + line * drawn.pitch;
    float height = frame_lines().y;
    vec2 place = vec2(2.0 * x - 1.0, 1.0 - 2.0 * y);
    float unit = u_output_resolution.y / u_output_resolution.x / 240.0;  // a line, of the width
    color = vec4(mean_at(x - red_at(place).x * unit, y, height).r, mean_at(x, y, height).g,
                 mean_at(x - blue_at(place).x * unit, y, height).b, 1.0);
}
