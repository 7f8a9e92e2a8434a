// The lamp with the original article's formulas.
#ifndef CAFFEINE_ARTICLE_SCENE
#define CAFFEINE_ARTICLE_SCENE

#include "material.glsl"

vec3 lamp_color() {
    return light_color * light_radiance;
}

// Light from one point of the lamp, which can be on its far side. The article weights it by the
// square of the lamp's angular radius instead of 2 (1 - cos).
vec3 shadow_ray_as_written(Surface surface, vec3 on_lamp) {
    vec3 direction = normalize(lamp_center() + light_radius * on_lamp - surface.place);
    if (first_hit(Ray(surface.place, direction)).what != lamp)
        return vec3(0.0);
    float angle = asin(min(light_radius / distance(surface.place, lamp_center()), 1.0));
    float slant = clamp(dot(surface.normal, direction), 0.0, 1.0);
    return lamp_color() * (slant * angle * angle * light_intensity);
}

#endif
