#version 410 core
// The beam: the light of one segment, added to that of all others in the frame. Linear light. Red:
// the part still to be emitted at the end of the frame. Green: all of it. The sum of green over all
// pixels is intensity * charge * (height / 512)^2, for any length, direction and width of the spot.
// Blue and alpha: green times the hue (tint.glsl).
#include "article.glsl"
#include "as_written.glsl"
#include "beam_segment.glsl"
#include "decay.glsl"
#include "reference_height.glsl"

uniform vec2 u_resolution;
uniform bool decay_by_place = false;  // @label "Approximate decay"  @group "Article"  @when !as_written
                                      // @help "The article's shortcut f = 0: light fades by its position along the segment instead of by its age. It looks the same unless segments are short or spots are wide."

flat in vec4 ends;
flat in vec2 charges;
flat in vec2 ages;
flat in float sigma;
flat in float seconds;
flat in vec2 hue;
out vec4 color;

// Light at one position. x: still to be emitted, y: all of it.
vec2 light_at(vec2 place, float segment_length) {
    vec2 at = beam_segment_place(place, ends.xy, ends.zw);
    float fade = ages.x - ages.y;
    vec2 light = vec2(beam_segment_light(at, segment_length, sigma, fade, charges),
                      beam_segment_light(at, segment_length, sigma, 0.0, charges));
    if (decay_by_place)
        light.x = light.y * decay_at_place(at.x, segment_length, fade);
    return light * vec2(exp(-ages.y), 1.0);
}

vec2 light_over_pixel(float segment_length) {
    int n = beam_segment_readings(sigma);
    vec2 sum = vec2(0.0);
    int y = 0;
    do {
        int x = 0;
        do {
            vec2 reading = beam_segment_reading(ivec2(x, y), n);
            sum += light_at(gl_FragCoord.xy + reading, segment_length);
            ++x;
        } while (x < n);
        ++y;
    } while (y < n);
    return sum / float(n * n);
}

// Scaled so that a still picture at the look's defaults and 60 frames per second is as bright as
// with the correct formulas. The article's formulas lack the spot's area. They show the light at
// the end of the frame instead of the light emitted during it.
vec2 article_light(float segment_length) {
    const float default_sigma = 1.2;
    float area = root_of_2_pi * default_sigma * u_resolution.y / reference_height;
    float shown = 60.0 * 0.001 * default_decay_time;
    vec2 at = beam_segment_place(gl_FragCoord.xy, ends.xy, ends.zw);
    float light = light_as_written(at, segment_length, sigma, ages);
    return vec2(charges.y * light / (area * shown), 0.0);
}

void main() {
    float segment_length = distance(ends.xy, ends.zw);
    vec2 light = as_written ? article_light(segment_length) : light_over_pixel(segment_length);
    color = vec4(light, hue * (as_written ? light.x : light.y));
}
