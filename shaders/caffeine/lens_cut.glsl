// The lens, split where the edge of the lamp crosses it. The lamp is very bright. Where it is out
// of focus, rays that just hit or just miss it would otherwise cause most of the noise.
#ifndef CAFFEINE_LENS_CUT
#define CAFFEINE_LENS_CUT

#include "camera.glsl"
#include "scene.glsl"

struct LensCut {
    float lamp_share;  // fraction of the chord whose rays hit the lamp; 0 if it is not split
    vec2 lamp;         // a point of that part
    vec2 beside;       // a point of the other part
};

// Where rays through `focus` hit the lamp: the points `from` + s `along` of the lens, with s
// between the two numbers. Rays that touch the lamp form a cone with its tip in `focus`. So its
// edge on the lens is where (w d)^2 = (w^2 - r^2) d^2. The vector d goes from the lens to `focus`,
// and w from there to the lamp's centre. Returns (0, 0) if the edge is not an ellipse or the line
// misses it.
vec2 lamp_on_lens(Camera view, vec3 focus, vec2 from, vec2 along) {
    const vec2 nowhere = vec2(0.0);
    if (dot(lamp_center() - view.eye, view.forward) <= light_radius)
        return nowhere;
    vec3 way = focus - view.eye - across_lens(view, from);
    vec3 step = across_lens(view, along);
    vec3 onward = lamp_center() - focus;
    float outside = dot(onward, onward) - light_radius * light_radius;
    float onward_step = dot(onward, step);
    float onward_way = dot(onward, way);
    float a = onward_step * onward_step - outside * dot(step, step);
    float half_b = outside * dot(way, step) - onward_way * onward_step;
    float c = onward_way * onward_way - outside * dot(way, way);
    float root_squared = half_b * half_b - a * c;
    if (a >= 0.0 || root_squared <= 0.0)
        return nowhere;
    return (-half_b + sqrt(root_squared) * vec2(1.0, -1.0)) / a;
}

// The direction on the lens across the lamp's edge, of length 1. It points to where the line
// through `focus` and the lamp's centre intersects the plane of the lens.
vec2 across_edge(Camera view, vec3 focus) {
    vec3 onward = lamp_center() - focus;
    vec3 way = focus - view.eye;
    vec3 towards = way * dot(onward, view.forward) - onward * dot(way, view.forward);
    vec2 direction = vec2(dot(towards, view.right), dot(towards, view.up));
    float size = length(direction);
    return size > 0.0 ? direction / size : vec2(1.0, 0.0);
}

// Maps a uniform point of the lens to one point on each part of the chord through it.
LensCut cut_by_lamp(Camera view, vec3 focus, vec2 on_lens) {
    vec2 along = across_edge(view, focus);
    vec2 side = vec2(-along.y, along.x);
    vec2 from = dot(on_lens, side) * side;
    float half_chord = sqrt(max(1.0 - dot(from, from), 0.0));
    vec2 lamp = clamp(lamp_on_lens(view, focus, from, along), -half_chord, half_chord);
    float length = lamp.y - lamp.x;
    float share = length / (2.0 * half_chord);
    if (!(share > 0.0 && share < 1.0))
        return LensCut(0.0, on_lens, on_lens);
    float place = clamp(0.5 + 0.5 * dot(on_lens, along) / half_chord, 0.0, 1.0);
    float beside = place * (2.0 * half_chord - length) - half_chord;
    if (beside > lamp.x)
        beside += length;
    return LensCut(share, from + mix(lamp.x, lamp.y, place) * along, from + beside * along);
}

#endif
