#version 410 core
// Glow: the picture, blurred. Linear light.
// look.json draws this pass at a quarter of the picture's size ("scale"), which is faster.
uniform sampler2D image;    // "inputs" in look.json: the source, with mipmaps
uniform vec2 u_resolution;  // names that begin with u_ are set by the program, see docs/annotations.md
uniform float glow_radius = 1.5;  // @range 0.3 6  @scale log  @label "Radius"  @unit "% of height"  @group "Glow"  @when glow_amount > 0
                                  // @help "Standard deviation of the glow, as a fraction of the picture's height."

in vec2 uv;  // 0..1 from the bottom left
out vec4 color;

const int reach = 4;  // samples on each side

void main() {
    // Samples that are half a standard deviation apart, weighted by a Gaussian. Each one reads the
    // mipmap whose texels have about that size, so that no pixel between two samples is missed.
    vec2 step_size = 0.005 * glow_radius * vec2(u_resolution.y / u_resolution.x, 1.0);
    float level = log2(max(step_size.y * float(textureSize(image, 0).y), 1.0));
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            float weight = exp(-0.125 * float(x * x + y * y));
            sum += weight * textureLod(image, uv + vec2(x, y) * step_size, level).rgb;
            weights += weight;
        }
    color = vec4(sum / weights, 1.0);
}
