// Materials: a fraction of the light is scattered diffusely (Lambert). The rest goes into a lobe
// around the mirrored ray. The lobe widens with roughness.
#ifndef CAFFEINE_MATERIAL
#define CAFFEINE_MATERIAL

#include "scene.glsl"

uniform float atom_roughness = 0.0;    // @range 0 1  @limit 0 1  @label "Atom roughness"  @group "Materials"  @when as_written || atom_matt < 1
                                       // @help "How blurred reflections on the atoms are. 0 is polished, 1 is like chalk."
uniform float coffee_roughness = 0.0;  // @range 0 1  @limit 0 1  @label "Coffee roughness"  @group "Materials"  @when as_written || coffee_matt < 1
                                       // @help "How blurred reflections on the coffee are. 0 is polished, 1 is like chalk."
uniform float atom_matt = 0.8;         // @range 0 1  @limit 0 1  @label "Atom diffuse"  @group "Materials"  @when !as_written
                                       // @help "Fraction of the light that the atoms scatter in all directions. The rest is reflected, as set by Atom roughness. 0 is metal, 1 is chalk."
uniform float coffee_matt = 0.8;       // @range 0 1  @limit 0 1  @label "Coffee diffuse"  @group "Materials"  @when !as_written
                                       // @help "Fraction of the light that the coffee scatters in all directions. The rest is reflected, as set by Coffee roughness. 0 is a mirror, 1 is chalk."
uniform float ray_offset = 1e-4;       // @range 0.00001 0.1  @limit 0 1  @scale log  @label "Ray offset"  @unit "Å"  @group "Sampling"
                                       // @help "How far above a surface its rays start, so that they don't hit it again."

const float pi = 3.14159265359;
const float smoothest = 0.005;  // a lower roughness counts as a mirror

struct Surface {
    vec3 place;
    vec3 normal;
    vec3 mirrored;  // direction of the mirrored ray
    vec3 color;
    float roughness;
    float matt;
};

Surface surface_at(Ray ray, Hit hit) {
    vec3 place = ray.origin + hit.away * ray.direction;
    bool is_coffee = hit.what == coffee;
    vec3 normal = is_coffee ? vec3(0.0, ray.direction.y < 0.0 ? 1.0 : -1.0, 0.0)
                            : normalize(place - hit.center);
    return Surface(place + ray_offset * normal, normal, reflect(ray.direction, normal),
                   is_coffee ? coffee_color : color_of_atom(hit.what),
                   is_coffee ? coffee_roughness : atom_roughness,
                   is_coffee ? coffee_matt : atom_matt);
}

// Maps a uniform point of the unit square to one of the unit sphere (Archimedes' hat-box theorem).
vec3 sphere_point(vec2 square) {
    float z = 1.0 - 2.0 * square.x;
    float around = 2.0 * pi * square.y;
    return vec3(sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(around), sin(around)), z);
}

// The direction to a point of a sphere. As roughness grows, the sphere moves from the end of the
// mirrored ray to the end of the normal. Its radius grows from 0 to 1. At roughness 1 it touches
// the surface, and the directions follow Lambert's law.
vec3 lobe_direction(Surface surface, float roughness, vec3 on_sphere) {
    vec3 towards = mix(surface.mirrored, surface.normal + on_sphere, roughness);
    float size = length(towards);
    return size > 1e-6 ? towards / size : surface.normal;
}

// Probability density of lobe_direction(), per steradian. The sphere's surface has the uniform
// density 1 / (4 pi r^2). The direction intersects it at the distances t1 and t2, at an angle with
// the cosine `slant` / r. Each intersection adds density t^2 / cosine.
float lobe_density(Surface surface, vec3 direction) {
    float roughness = surface.roughness;
    vec3 center = mix(surface.mirrored, surface.normal, roughness);
    float along = dot(center, direction);
    // |center|^2 - r^2, in a form without cancellation
    float outside = (1.0 - roughness) * (1.0 - roughness)
                  + 2.0 * roughness * (1.0 - roughness) * dot(surface.mirrored, surface.normal);
    float slant_squared = along * along - outside;
    if (along <= 0.0 || slant_squared <= 0.0 || dot(direction, surface.normal) <= 0.0)
        return 0.0;
    float slant = sqrt(slant_squared);
    float near = max(along - slant, 0.0);
    float far = along + slant;
    return (near * near + far * far) / (4.0 * pi * roughness * slant);
}

bool is_mirror(Surface surface) {
    return surface.roughness < smoothest;
}

// Probability density of Lambert's law, per steradian.
float even_density(Surface surface, vec3 direction) {
    return max(dot(surface.normal, direction), 0.0) / pi;
}

vec3 mirrored_direction(Surface surface, vec2 square) {
    return is_mirror(surface) ? surface.mirrored
                              : lobe_direction(surface, surface.roughness, sphere_point(square));
}

// Directions are distributed like the scattered light. So the returning light is only multiplied by
// the surface's colour.
vec3 bounced_direction(Surface surface, vec2 square) {
    bool is_even = square.x < surface.matt;
    // Rescales the number that made the choice, so that it is uniform again.
    square.x = is_even ? square.x / surface.matt
                       : (square.x - surface.matt) / (1.0 - surface.matt);
    return is_even ? lobe_direction(surface, 1.0, sphere_point(square))
                   : mirrored_direction(surface, square);
}

#endif
