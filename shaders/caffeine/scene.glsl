// The scene: the molecule over a plane of coffee, one lamp, and an even light from all sides.
#ifndef CAFFEINE_SCENE
#define CAFFEINE_SCENE

#include "molecule.glsl"

uniform float coffee_height = -2.0;       // @range -6 2  @limit -1000 1000  @label "Coffee level"  @unit "Å"  @group "Coffee"
                                          // @help "How high the plane of coffee stands. The middle of the molecule is at 0; what is below the level drowns."
uniform vec3 coffee_color = vec3(0.25, 0.1, 0.0153125);  // @color  @label "Coffee"  @group "Coffee"
uniform float light_angle = 4.73;         // @angle  @range 0 6.2832  @label "Lamp around"  @group "Lamp"
                                          // @help "Where the lamp stands around the molecule: 0 is to the right, a quarter turn is towards you."
uniform float light_height = 8.0;         // @range -2 30  @limit -1000 1000  @label "Lamp height"  @unit "Å"  @group "Lamp"
uniform float light_distance = 8.0;       // @range 0 30  @limit 0 1000  @label "Lamp distance"  @unit "Å"  @group "Lamp"
                                          // @help "From the upright axis through the molecule."
uniform float light_radius = 4.0;         // @range 0.05 8  @limit 0.01 100  @label "Lamp radius"  @unit "Å"  @group "Lamp"
                                          // @help "A large lamp throws soft shadows, a small one hard ones. A larger one also gives more light."
uniform float light_radiance = 6.0;       // @range 0 24  @limit 0 10000  @label "Lamp light"  @group "Lamp"
                                          // @help "What the lamp's surface gives off where its brightness, or how it is seen, is 1."
uniform float light_intensity = 4.1;      // @range 0 16  @limit 0 10000  @label "Lamp brightness"  @group "Lamp"
                                          // @help "How bright the lamp's light is on things and in mirrors."
uniform vec3 light_color = vec3(1.0, 1.0, 0.5);     // @color  @label "Lamp colour"  @group "Lamp"
uniform vec3 ambient = vec3(0.01, 0.01, 0.01);      // @color  @label "Ambient"  @group "Lamp"
                                                    // @help "Light that comes evenly from everywhere; also the background."

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
