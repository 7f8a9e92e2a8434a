#version 410 core
// Radar: a beam turns around the screen, and echoes glow where it has passed. The picture follows
// from the time alone, so it needs no earlier frame. Writes display values.
#include "color.glsl"
#include "noise.glsl"

uniform float u_time;       // s; names that begin with u_ are set by the program
uniform vec2 u_resolution;  // px

// A uniform is a slider. Its default is GLSL's own; the comment sets range, label and help.
uniform float turn_seconds = 4.0;    // @range 1 12  @limit 0.1 600  @scale log  @label "Time per turn"  @unit "s"  @group "Beam"
                                     // @help "How long the beam takes for one turn."
uniform float half_life = 0.9;       // @range 0.1 5  @limit 0.01 600  @scale log  @label "Half-life"  @unit "s"  @group "Phosphor"
                                     // @help "Time after which half of the light is left."
uniform vec3 phosphor_color = vec3(0.45, 1.0, 0.12);  // @color  @label "Afterglow"  @group "Phosphor"
uniform vec3 flash_color = vec3(0.45, 0.6, 1.0);      // @color  @label "Flash"  @group "Phosphor"
uniform int targets = 9;             // @range 0 24  @limit 0 64  @label "Targets"  @group "Echoes"
uniform float target_speed = 1.0;    // @range 0 4  @limit -100 100  @label "Speed"  @group "Echoes"  @when targets > 0
                                     // @help "How far the targets move from one turn to the next."
uniform float clutter = 0.5;         // @range 0 2  @limit 0 100  @label "Sea clutter"  @group "Echoes"  @identity 0
                                     // @help "Echoes of waves around the middle."
uniform int rings = 4;               // @range 0 10  @limit 0 50  @label "Range rings"  @group "Graticule"
uniform float ring_light = 0.12;     // @range 0 0.5  @limit 0 10  @label "Brightness"  @group "Graticule"  @when rings > 0
uniform float exposure = 1.5;        // @range 0.25 8  @limit 0 1000  @scale log  @label "Exposure"  @group "Picture"  @identity 1

in vec2 uv;  // 0..1 from the bottom left
out vec4 color;

const float two_pi = 6.28318530718;
const uint wave_rows = 90u;     // cells of clutter from the middle to the rim
const uint wave_columns = 240u; // and around

// 1 at x = 0, falling to 0 over a few widths.
float bump(float x, float width) {
    return exp(-0.5 * x * x / (width * width));
}

// Light of all targets at a position, when the beam passed in this turn. An echo is an arc: short
// along the range, wide across it, as a radar beam is.
float echoes(float radius, float angle, float turn) {
    float light = 0.0;
    for (int i = 0; i < targets; ++i) {
        vec3 random = noise(uvec2(i, 7), 0u);
        vec2 start = (0.25 + 0.6 * random.x) * vec2(cos(two_pi * random.y), sin(two_pi * random.y));
        vec2 heading = vec2(cos(two_pi * random.z), sin(two_pi * random.z));
        vec2 place = start + 0.012 * target_speed * mod(turn + 40.0 * random.z, 60.0) * heading;
        float across = mod(angle - atan(place.y, place.x) + 0.5 * two_pi, two_pi) - 0.5 * two_pi;
        float size = 0.6 + 0.8 * fract(7.0 * random.x);
        light += size * bump(radius - length(place), 0.007) * bump(across * radius, 0.018 * size);
    }
    return light;
}

// Waves reflect less with distance, and differ in each turn.
float waves(float radius, float angle, float turn) {
    uvec2 cell = uvec2(vec2(radius * float(wave_rows), angle / two_pi * float(wave_columns)));
    float random = noise(cell, uint(max(turn, 0.0)) + 1u).x;
    return clutter * pow(random, 6.0) * exp(-radius / 0.16);
}

// The rim with a mark every 10 degrees, longer every 30.
float marks(float radius, float angle, float pixel) {
    float degrees = 360.0 * angle / two_pi;
    float from_ten = abs(mod(degrees + 5.0, 10.0) - 5.0);
    bool is_long = abs(mod(degrees + 15.0, 30.0) - 15.0) < 5.0;
    float inner = is_long ? 0.955 : 0.975;
    float along = smoothstep(inner, inner + pixel, radius) * smoothstep(1.0 + pixel, 1.0, radius);
    return max(bump(radius - 1.0, 0.8 * pixel),
               along * bump(from_ten * two_pi / 360.0 * radius, 0.8 * pixel));
}

void main() {
    float pixel = 2.0 / (0.94 * min(u_resolution.x, u_resolution.y));
    vec2 place = (gl_FragCoord.xy - 0.5 * u_resolution) * pixel;  // the rim is at radius 1
    float radius = length(place);
    float angle = mod(atan(place.x, place.y), two_pi);  // clockwise from the top
    float turns = u_time / turn_seconds;
    float turn = floor(turns - angle / two_pi);           // the turn that passed here last
    float age = (turns - angle / two_pi - turn) * turn_seconds;

    float from_ring = (fract(radius * float(rings) + 0.5) - 0.5) / float(max(rings, 1));
    float ring = rings > 0 ? bump(from_ring, pixel) : 0.0;
    float polar = 0.25 * two_pi - angle;                  // counterclockwise from the right
    vec3 light = vec3(0.0);
    // The light of this turn and of the two before it.
    for (int i = 0; i < 3; ++i) {
        float then = turn - float(i);
        float seconds = age + float(i) * turn_seconds;
        float excited = 0.03 + 1.6 * echoes(radius, polar, then) +
                        waves(radius, angle, then) +
                        ring_light * ring;
        light += excited * (exp2(-seconds / half_life) * phosphor_color +
                            4.0 * exp2(-seconds / 0.05) * flash_color);
    }
    light *= smoothstep(1.0, 1.0 - pixel, radius);
    light += ring_light * (0.3 * ring * step(radius, 1.0) + marks(radius, angle, pixel)) *
             phosphor_color;
    color = vec4(srgb_encode(1.0 - exp(-exposure * light)), 1.0);
}
