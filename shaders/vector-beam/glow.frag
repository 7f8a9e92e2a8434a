#version 410 core
// Glow, one direction: light scattered in the glass, as two Gaussians at a quarter of the size. The
// second is four times as wide. Red: the narrow one. Green: the wide one. Blue and alpha: the hue
// of both together (tint.glsl). Linear light. The weights of each add up to 1.
#include "reference_height.glsl"
#include "tint.glsl"

uniform sampler2D image;
uniform vec2 direction;   // (1, 0) or (0, 1); with (1, 0) the image is a coloured picture
uniform float level;      // mipmap level of the image: in the first direction it averages 4 x 4
uniform vec2 u_resolution;
uniform float glow_radius = 5.0;  // @range 1 20  @limit 0.2 40  @scale log  @label "Radius"  @unit "px at 512 lines"  @group "Glow"  @when !as_written && glow_amount > 0  @photo amount
                                  // @help "Standard deviation of the narrow glow around the lines. The wide glow spreads four times as far."

in vec2 uv;
out vec4 color;

const float wide = 4.0;

// The strength twice, for both Gaussians, and the hue.
vec4 light_at(vec2 at) {
    vec4 light = textureLod(image, at, level);
    return direction.x == 0.0 ? light : vec4(vec2(strength_of(light.rgb)), hue_of(light.rgb));
}

void main() {
    float sigma = max(glow_radius * u_resolution.y / reference_height, 0.3);  // texels
    vec2 falls = -0.5 / (vec2(1.0, wide * wide) * sigma * sigma);
    int reach = min(int(ceil(2.5 * wide * sigma)), 256);
    vec2 sum = vec2(0.0);
    vec2 total = vec2(0.0);
    vec3 hues = vec3(0.0);  // weighted sum of the hues; z: sum of the weights
    for (int i = -reach; i <= reach; ++i) {
        vec2 weights = exp(falls * float(i * i));
        vec4 light = light_at(uv + float(i) * direction / u_resolution);
        sum += weights * light.rg;
        hues += dot(weights, light.rg) * vec3(light.ba, 1.0);
        total += weights;
    }
    color = vec4(sum / total, hues.z > 0.0 ? hues.xy / hues.z : vec2(0.0));
}
