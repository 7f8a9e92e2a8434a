#version 410 core
// The original article's method, mistakes included (docs/looks.md lists them). Sums linear light.
// Alpha counts the samples.
#include "article_scene.glsl"
#include "camera.glsl"
#include "noise.glsl"

uniform sampler2D even_numbers;   // red, green: uniform numbers; blue, alpha: points on the circle
uniform sampler2D sphere_points;
uniform int u_samples;
uniform int bounces = 3;
uniform int samples_per_frame = 1;
uniform int converge = 4096;
uniform int seed = 0;

out vec4 color;

vec2 frame_offset;
vec2 state = vec2(0.0);

vec4 numbers_here(sampler2D numbers) {
    vec2 place = gl_FragCoord.xy / vec2(textureSize(numbers, 0)) + frame_offset + state;
    return texture(numbers, place);
}

vec2 even_pair() {
    vec2 pair = numbers_here(even_numbers).rg;
    state += pair;
    return pair;
}

vec2 circle_point() {
    vec2 point = numbers_here(even_numbers).ba;
    state += point;
    return point;
}

// The article compares here (`randState == r3.xy`) instead of adding. The next number of this kind
// is therefore the same.
vec3 sphere_point_as_written() {
    return numbers_here(sphere_points).xyz;
}

// The lens is brighter in its middle, because the radius is a uniform random number.
Ray ray_as_written() {
    vec2 jitter = even_pair() - 0.5;
    vec2 around = circle_point();
    Camera view = camera();
    return lens_ray(view, focus_point(view, gl_FragCoord.xy, jitter), around * even_pair().x);
}

vec3 light_as_written(Ray ray) {
    vec3 light = vec3(0.0);
    vec3 carried = vec3(1.0);
    for (int i = 0; i <= bounces; ++i) {  // one more than `bounces`
        Hit hit = first_hit(ray);
        if (hit.what == nothing)
            return light + ambient * carried;
        if (hit.what == lamp)
            return light + lamp_color() * carried;  // already counted by the shadow ray
        Surface surface = surface_at(ray, hit);
        carried *= surface.color;
        light += carried * shadow_ray_as_written(surface, sphere_point_as_written());
        vec3 rough = surface.normal + sphere_point_as_written();
        ray.direction = normalize(mix(surface.mirrored, rough, surface.roughness));
        ray.origin = surface.place;
    }
    return light;
}

void main() {
    frame_offset = noise(uvec2(u_samples, seed), 3u).xy;
    color = vec4(light_as_written(ray_as_written()), 1.0);
}
