// The camera: a thin lens. The mouse rotates it around its target.
#ifndef CAFFEINE_CAMERA
#define CAFFEINE_CAMERA

#include "molecule.glsl"

uniform vec2 u_resolution;
uniform mat4 u_camera;

uniform vec3 camera_place = vec3(0.0, 0.0, 10.0);  // @range -20 20  @limit -1000 1000  @label "Camera position"  @unit "Å"  @group "Camera"
                                                   // @help "Position before orbiting: right, up and towards the viewer, from the centre of the molecule. Drag the picture with the right mouse button to orbit."
uniform vec3 camera_target = vec3(0.0, 0.0, 0.0);  // @range -5 5  @limit -1000 1000  @label "Camera target"  @unit "Å"  @group "Camera"
                                                   // @help "Point that the camera looks at and orbits."
uniform float field_of_view = 60.0;  // @range 10 120  @limit 1 170  @label "Field of view"  @unit "°"  @group "Camera"
                                     // @help "Vertical angle of view, from the top to the bottom of the picture."
uniform float focal_plane = 3.0;     // @range -5 5  @limit -1000 1000  @label "Focal plane"  @unit "Å"  @group "Camera"  @when aperture > 0
                                     // @help "Distance of the plane in focus, in front of the camera target. Below 0, it is behind the target."
uniform float aperture = 0.1;        // @range 0 1  @limit 0 100  @label "Aperture"  @unit "Å"  @group "Camera"  @identity 0  @was focal_length
                                     // @help "Radius of the lens. A wider lens blurs more in front of and behind the focal plane. At 0, everything is sharp."
uniform bool antialias = true;       // @label "Anti-aliasing"  @group "Sampling"  @identity 0
                                     // @help "Samples a different point of the pixel each time, which smooths edges."

struct Camera {
    vec3 eye;
    vec3 right;
    vec3 up;
    vec3 forward;
};

Camera camera() {
    vec3 eye = camera_target + mat3(u_camera) * (camera_place - camera_target);
    vec3 forward = normalize(camera_target - eye);
    vec3 right = normalize(cross(forward, mat3(u_camera) * vec3(0.0, 1.0, 0.0)));
    return Camera(eye, right, cross(right, forward), forward);
}

// Maps a uniform point of the unit square to a uniform point of the unit disk (P. Shirley and K.
// Chiu, "A Low Distortion Map Between Disk and Square", JGT 2(3), 1997).
vec2 disk_point(vec2 square) {
    vec2 place = 2.0 * square - 1.0;
    bool is_wide = abs(place.x) > abs(place.y);
    float radius = is_wide ? place.x : place.y;
    float ratio = radius == 0.0 ? 0.0 : (is_wide ? place.y : place.x) / radius;
    float angle = 0.78539816339 * ratio;
    vec2 on_axis = radius * vec2(cos(angle), sin(angle));
    return is_wide ? on_axis : on_axis.yx;
}

// The point in the focal plane that a pixel shows. `from_middle` is the offset from the pixel's
// centre, -0.5..0.5 px.
vec3 focus_point(Camera view, vec2 pixel, vec2 from_middle) {
    vec2 place = (2.0 * (pixel + (antialias ? from_middle : vec2(0.0))) - u_resolution) / u_resolution.y;
    place *= tan(radians(0.5 * field_of_view));
    float depth = max(dot(camera_target - view.eye, view.forward) - focal_plane, 0.01);
    return view.eye + depth * (view.forward + place.x * view.right + place.y * view.up);
}

vec3 across_lens(Camera view, vec2 on_lens) {
    return aperture * (on_lens.x * view.right + on_lens.y * view.up);
}

// `on_lens` is a point of the unit disk.
Ray lens_ray(Camera view, vec3 focus, vec2 on_lens) {
    vec3 origin = view.eye + across_lens(view, on_lens);
    return Ray(origin, normalize(focus - origin));
}

#endif
