#version 410 core
// One light path per pixel, added to the previous ones. Linear light. Alpha counts the paths. The
// estimate is unbiased: the mean of the paths converges to the picture (path tracing: J. T. Kajiya,
// "The Rendering Equation", SIGGRAPH 1986).
#include "lamp.glsl"
#include "lens_cut.glsl"
#include "sobol.glsl"

uniform sampler2D points;
uniform int u_samples;

uniform int bounces = 3;              // @range 0 10  @limit 0 32  @label "Bounces"  @group "Sampling"  @identity 0
                                      // @help "Number of times light is reflected before it reaches the visible surface. 0 is direct light only."
uniform int samples_per_frame = 1;    // @range 1 64  @limit 1 1024  @label "Samples per frame"  @group "Sampling"
                                      // @help "Number of samples that each frame adds. In the window, only samples that fit into 1/20 s are added."
uniform int converge = 4096;          // @range 0 16384  @limit 0 16777216  @label "Sample limit"  @group "Sampling"
                                      // @help "Rendering stops at this number of samples. At 0 it never converges: each frame shows only its own samples."
uniform int seed = 0;                 // @range 0 100 1  @limit 0 1000000  @label "Seed"  @group "Sampling"
                                      // @help "Seed of the random numbers. Another seed gives different noise, but converges to the same picture."

out vec4 color;

const int choice_block = 63;  // not used by any surface

// Four numbers, 0 <= n < 1. Blocks 0 to 4 are the 20 dimensions of one sequence. Deeper bounces use
// the dimensions of the first four in another order.
vec4 sample_numbers(int block) {
    uint index = uint(u_samples) & ((1u << sobol_bits) - 1u);
    uint round = uint(u_samples) >> sobol_bits;
    uvec4 seeds = seeds_of(uvec3(gl_FragCoord.xy, uint(block) + 64u * (round + 1024u * uint(seed))));
    int column = block;
    if (block > 4) {
        column = 1 + (block - 1) % 4;
        index = shuffled_index(index, seeds.x ^ 0x9e3779b9u);
    }
    vec4 fraction = texelFetch(points, ivec2(column, int(index)), 0);
    return fractions(owen_scrambled(uvec4(fraction * 16777216.0) << 8u, seeds));
}

vec3 light_along(Ray ray) {
    vec3 light = vec3(0.0);
    vec3 carried = vec3(1.0);
    for (int bounce = 0; bounce <= bounces + 1; ++bounce) {
        Hit hit = first_hit(ray);
        if (hit.what == nothing) {
            light += carried * ambient;
            break;
        }
        if (hit.what == lamp) {
            if (bounce == 0)
                light += lamp_shown();
            break;
        }
        if (bounce > bounces)
            break;
        Surface surface = surface_at(ray, hit);
        vec4 numbers = sample_numbers(1 + bounce);
        carried *= surface.color;
        light += carried * lamp_off(surface, numbers.xy, numbers.zw);
        ray = Ray(surface.place, bounced_direction(surface, numbers.zw));
    }
    return light;
}

// If the lamp's edge splits the lens and nothing hides the lamp, its part is known without a path.
// Otherwise the path goes through one of the parts, with a probability equal to its size.
void main() {
    vec4 numbers = sample_numbers(0);
    Camera view = camera();
    vec3 focus = focus_point(view, gl_FragCoord.xy, numbers.xy - 0.5);
    vec2 on_lens = disk_point(numbers.zw);
    LensCut cut = cut_by_lamp(view, focus, on_lens);
    float share = 1.0;
    vec3 light = vec3(0.0);
    if (cut.lamp_share > 0.0) {
        on_lens = sample_numbers(choice_block).x < cut.lamp_share ? cut.lamp : cut.beside;
        if (sees_lamp(lens_ray(view, focus, cut.lamp))) {
            on_lens = cut.beside;
            share -= cut.lamp_share;
            light += cut.lamp_share * lamp_shown();
        }
    }
    color = vec4(light + share * light_along(lens_ray(view, focus, on_lens)), 1.0);
}
