#version 410 core
// The beam: one square for each sample of the signal, large enough for its spot.
#include "spot.glsl"
#include "tint.glsl"
#include "tube.glsl"
#include "decay.glsl"
#include "fit.glsl"
#include "beam_kind.glsl"
#include "as_written.glsl"
#include "reference_height.glsl"

uniform vec2 u_resolution;

in vec2 position;       // -1..1, y up
in float intensity;     // 1: full current for 1/4096 of 1/60 s
in float age_seconds;   // time before the end of the frame

flat out vec2 middle;   // px from the bottom left
flat out float width;   // px
flat out vec4 charge;   // custom tube: the intensity that is left, per channel
                        // measured tube: the part that each term has emitted; alpha: all of it

vec4 charge_at_the_end() {
    if (as_written)
        return vec4(intensity);
    vec3 parts = has_tube() ? spent_after(age_seconds / term_seconds()) : left_after(age_seconds);
    return intensity * vec4(parts, 1.0);
}

// GL drops a point whose centre is outside the picture, even if part of its spot is inside. So the
// square is moved to the nearest position inside and enlarged by the distance it was moved.
void place_square(vec2 place, float half_side) {
    vec2 inside = clamp(place, -1.0, 1.0);
    vec2 moved = abs(place - inside) * 0.5 * u_resolution;
    float moved_px = max(moved.x, moved.y);
    bool is_seen = moved_px < half_side;
    gl_Position = is_seen ? vec4(inside, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
    gl_PointSize = 2.0 * (half_side + moved_px);
}

// The article's size: at most twice that at 512 lines. The square is only as wide as beam_width.
void place_as_written(vec2 place) {
    gl_Position = vec4(place, 0.0, 1.0);
    gl_PointSize = beam_width * min(u_resolution.y / reference_height, 2.0);
}

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    gl_PointSize = 1.0;
    if (draws_segments())
        return;
    vec2 place = position * signal_size(u_resolution);
    middle = (0.5 + 0.5 * place) * u_resolution;
    width = beam_width * u_resolution.y / reference_height;
    charge = charge_at_the_end() * tint_of_charge();
    if (as_written)
        place_as_written(place);
    else
        place_square(place, spot_reach() * width + 0.5);
}
