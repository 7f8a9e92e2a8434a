// The graticule of an oscilloscope: divisions, and axes with ticks at each fifth of a division.
#ifndef AFTERGLOW_GRATICULE
#define AFTERGLOW_GRATICULE

// Fraction of a pixel that a line of `width` px covers. Its middle is `distance_px` away.
float line_coverage(float distance_px, float width) {
    return clamp(0.5 * width + 0.5 - abs(distance_px), 0.0, 1.0) * min(width, 1.0);
}

// Distance in px to the nearest multiple of `spacing` (in divisions), for x and y.
vec2 distance_to_lines(vec2 place, float spacing, vec2 division_px) {
    return abs(place / spacing - round(place / spacing)) * spacing * division_px;
}

// Ticks on the x axis: short strokes across it at each fifth of a division.
float ticks_coverage(vec2 place, vec2 division_px, float width) {
    const float half_length = 0.1;  // divisions
    float stroke = line_coverage(distance_to_lines(place, 0.2, division_px).x, width);
    float end = clamp((half_length - abs(place.y)) * division_px.y + 0.5, 0.0, 1.0);
    return stroke * end;
}

// The lines at `place` (in divisions from the middle): 0 between lines, 0.6 on lines, 1 on axes and
// ticks. `divisions` is the total number across and up. The outermost lines are the frame.
float graticule_coverage(vec2 place, vec2 divisions, vec2 division_px, float width) {
    vec2 inside = clamp((0.5 * divisions - abs(place)) * division_px + 0.5 * width + 0.5, 0.0, 1.0);
    // With an odd number of divisions, the lines are half a division off the middle.
    vec2 shifted = place + 0.5 * mod(divisions, 2.0);
    vec2 away = distance_to_lines(shifted, 1.0, division_px);
    float lines = max(line_coverage(away.x, width), line_coverage(away.y, width));
    float axes = max(line_coverage(place.x * division_px.x, width),
                     line_coverage(place.y * division_px.y, width));
    float ticks = max(ticks_coverage(place, division_px, width),
                      ticks_coverage(place.yx, division_px.yx, width));
    return max(0.6 * lines, max(axes, ticks)) * inside.x * inside.y;
}

#endif
