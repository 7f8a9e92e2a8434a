#version 410 core
// Glow: the phosphor's light, blurred, at a quarter of the picture's size. Red and green as stored.
uniform sampler2D image;
uniform vec2 u_resolution;
uniform float glow_radius = 1.2;  // @range 0.3 6  @scale log  @label "Radius"  @unit "% of height"  @group "Glow"  @when glow_amount > 0
                                  // @help "Standard deviation of the glow, as a fraction of the picture's height."

in vec2 uv;
out vec4 color;

const int reach = 4;  // samples on each side

void main() {
    // Samples half a standard deviation apart. Each one reads the mipmap with texels of that size.
    vec2 step_size = 0.005 * glow_radius * vec2(u_resolution.y / u_resolution.x, 1.0);
    float level = log2(max(step_size.y * float(textureSize(image, 0).y), 1.0));
    vec2 sum = vec2(0.0);
    float weights = 0.0;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            float weight = exp(-0.125 * float(x * x + y * y));
            sum += weight * textureLod(image, uv + vec2(x, y) * step_size, level).rg;
            weights += weight;
        }
    color = vec4(sum / weights, 0.0, 1.0);
}
