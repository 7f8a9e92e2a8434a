// The lamp: a sphere. Seen from a point, it covers a cone of directions. Its reflection in a
// surface is sampled both in that cone and in the surface's lobe. The weights of both make the lamp
// count once (balance heuristic: E. Veach and L. Guibas, "Optimally Combining Sampling Techniques
// for Monte Carlo Rendering", SIGGRAPH 1995).
#ifndef CAFFEINE_LAMP
#define CAFFEINE_LAMP

#include "material.glsl"

uniform float light_shown = 1.0;  // @range 0 8  @limit 0 10000  @label "Lamp visible brightness"  @group "Lamp"  @when !as_written
                                  // @help "Brightness of the lamp itself in the picture, as if behind dark glass. Its light on objects and its reflections stay unchanged."

vec3 lamp_light() {
    return light_color * (light_intensity * light_radiance);
}

// The lamp as the camera sees it. A `light_shown` of 1 is the article's.
vec3 lamp_shown() {
    return light_color * (light_shown * light_radiance);
}

// 1 - cos of half the cone's angle. Below 0 inside the lamp, where no cone exists. The cone's solid
// angle is 2 pi times this value.
float lamp_cone(vec3 place) {
    vec3 away = lamp_center() - place;
    float sine_squared = light_radius * light_radius / dot(away, away);
    return sine_squared < 1.0 ? sine_squared / (1.0 + sqrt(1.0 - sine_squared)) : -1.0;
}

// Probability density of lamp_direction() within the cone, per steradian.
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

bool sees_lamp(Ray ray) {
    return sphere_entry(ray, lamp_center(), light_radius) > 0.0 && first_hit(ray).what == lamp;
}

// All of the lamp's light that a surface reflects, before the surface's colour. A bounce that hits
// the lamp therefore adds nothing. Each sample takes one direction of the lamp's cone and one of
// the lobe. So the choice between diffuse and specular reflection adds no noise.
vec3 lamp_off(Surface surface, vec2 cone_square, vec2 lobe_square) {
    float cone = lamp_cone(surface.place);
    if (cone <= 0.0)
        return vec3(0.0);
    float density = lamp_density(cone);
    vec3 directions[2] = vec3[](lamp_direction(surface.place, cone, cone_square),
                                mirrored_direction(surface, lobe_square));
    vec2 mirrored = vec2(0.0, 1.0);  // weight of each direction in the specular reflection
    if (!is_mirror(surface)) {
        mirrored = vec2(lobe_density(surface, directions[0]), lobe_density(surface, directions[1]));
        mirrored /= density + mirrored;
    }
    vec2 shares = (1.0 - surface.matt) * mirrored;
    shares.x += surface.matt * even_density(surface, directions[0]) / density;
    float light = 0.0;
    for (int way = 0; way < 2; ++way)
        if (shares[way] > 0.0 && sees_lamp(Ray(surface.place, directions[way])))
            light += shares[way];
    return light * lamp_light();
}

#endif
