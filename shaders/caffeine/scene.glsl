// The scene: the molecule over a plane of coffee, one lamp, and uniform ambient light.
#ifndef CAFFEINE_SCENE
#define CAFFEINE_SCENE

#include "molecule.glsl"

uniform float coffee_height = -2.0;       // @range -6 2  @limit -1000 1000  @label "Coffee level"  @unit "Å"  @group "Coffee"
                                          // @help "Height of the coffee's surface. 0 is the centre of the molecule. Everything below the surface is submerged."
uniform vec3 coffee_color = vec3(0.25, 0.1, 0.0153125);  // @color  @label "Coffee colour"  @group "Coffee"
                                                         // @help "Colour of the coffee."
uniform float light_angle = 4.73;         // @angle  @range 0 6.2832  @label "Lamp azimuth"  @group "Lamp"
                                          // @help "Direction of the lamp around the molecule. 0 is to the right, a quarter turn is towards the viewer."
uniform float light_height = 8.0;         // @range -2 30  @limit -1000 1000  @label "Lamp height"  @unit "Å"  @group "Lamp"
                                          // @help "Height of the lamp above the centre of the molecule."
uniform float light_distance = 8.0;       // @range 0 30  @limit 0 1000  @label "Lamp distance"  @unit "Å"  @group "Lamp"
                                          // @help "Horizontal distance from the vertical axis through the molecule."
uniform float light_radius = 4.0;         // @range 0.05 8  @limit 0.01 100  @label "Lamp radius"  @unit "Å"  @group "Lamp"
                                          // @help "Radius of the lamp. A large lamp casts soft shadows, a small one hard shadows. A larger one also gives more light."
uniform float light_radiance = 6.0;       // @range 0 24  @limit 0 10000  @label "Lamp radiance"  @group "Lamp"
                                          // @help "Light from the lamp's surface where Lamp intensity or Lamp visible brightness is 1. 0 turns the lamp off."
uniform float light_intensity = 4.1;      // @range 0 16  @limit 0 10000  @label "Lamp intensity"  @group "Lamp"
                                          // @help "Strength of the lamp's light on objects and in reflections."
uniform vec3 light_color = vec3(1.0, 1.0, 0.5);     // @color  @label "Lamp colour"  @group "Lamp"
                                                    // @help "Colour of the lamp's light."
uniform vec3 ambient = vec3(0.01, 0.01, 0.01);      // @color  @label "Ambient light"  @group "Lamp"
                                                    // @help "Even light from all directions. It is also the background."

const int coffee = 4;
const int lamp = 5;
const int nothing = 6;
const float far_away = 1e30;

vec3 lamp_center() {
    return vec3(cos(light_angle) * light_distance, light_height, sin(light_angle) * light_distance);
}

void meet_coffee(Ray ray, inout Hit hit) {
    float away = (coffee_height - ray.origin.y) / ray.direction.y;
    if (away > 0.0 && away < hit.away)
        hit = Hit(away, vec3(0.0), coffee);
}

Hit first_hit(Ray ray) {
    Hit hit = Hit(far_away, vec3(0.0), nothing);
    meet_molecule(ray, hit);
    meet_coffee(ray, hit);
    meet_sphere(ray, lamp, light_radius, lamp_center(), hit);
    return hit;
}

#endif
