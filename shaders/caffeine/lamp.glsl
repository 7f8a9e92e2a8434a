// The lamp, a sphere: seen from a place it covers a cone of directions, and these are sampled. What a
// bounce meets by itself and what is sampled here are weighted against each other, so that the lamp
// counts once (balance heuristic: E. Veach and L. Guibas, "Optimally Combining Sampling Techniques
// for Monte Carlo Rendering", SIGGRAPH 1995).
#ifndef CAFFEINE_LAMP
#define CAFFEINE_LAMP

#include "material.glsl"

uniform float light_shown = 1.0;  // @range 0 8  @limit 0 10000  @label "Lamp as seen"  @group "Lamp"
                                  // @help "How bright the lamp itself is in the picture, as if behind a dark glass. Its light on things stays; so do its mirror images."

vec3 lamp_light() {
    return light_color * (light_intensity * article_radiance);
}

// Seen by the camera; 1 is the article's.
vec3 lamp_shown() {
    return light_color * (light_shown * article_radiance);
}

// 1 - cos of half the cone's angle; below 0 inside the lamp, where there is no cone. The cone's solid
// angle is 2 pi times it.
float lamp_cone(vec3 place) {
    vec3 away = lamp_center() - place;
    float sine_squared = light_radius * light_radius / dot(away, away);
    return sine_squared < 1.0 ? sine_squared / (1.0 + sqrt(1.0 - sine_squared)) : -1.0;
}

// How densely lamp_direction() goes to any direction of the cone, a steradian.
float lamp_density(float cone) {
    return cone > 0.0 ? 1.0 / (2.0 * pi * cone) : 0.0;
}

vec3 lamp_direction(vec3 place, float cone, vec2 square) {
    vec3 axis = normalize(lamp_center() - place);
    vec3 side = normalize(abs(axis.y) < 0.9 ? cross(axis, vec3(0.0, 1.0, 0.0))
                                            : cross(axis, vec3(1.0, 0.0, 0.0)));
    float less = square.x * cone;
    float sine = sqrt(max(0.0, less * (2.0 - less)));
    float around = 2.0 * pi * square.y;
    return (1.0 - less) * axis + sine * (cos(around) * side + sin(around) * cross(axis, side));
}

// The lamp's light off a surface along one sampled direction, before the surface's colour.
vec3 sampled_lamp(Surface surface, vec2 square) {
    float cone = lamp_cone(surface.place);
    vec3 direction = lamp_direction(surface.place, cone, square);
    float scattered = scattered_density(surface, direction);
    if (cone <= 0.0 || scattered <= 0.0 || first_hit(Ray(surface.place, direction)).what != lamp)
        return vec3(0.0);
    return lamp_light() * (scattered / (lamp_density(cone) + scattered));
}

// The weight of a lamp that a bounce met.
float met_lamp_weight(vec3 from, float bounce_density) {
    return bounce_density < 0.0
               ? 1.0
               : bounce_density / (bounce_density + lamp_density(lamp_cone(from)));
}

#endif
