// The glass of a tube: its curvature, edge, vignette and scanlines.
// Positions on the glass are -1..1 in x and y, with (0, 0) in the middle.
#ifndef AFTERGLOW_GLASS
#define AFTERGLOW_GLASS

// Barrel distortion: the position on the tube that is shown at `place` of the picture. The middle
// of each side stays in place. Corners move outwards by `amount` * 40/36 of their position.
vec2 barrel(vec2 place, float amount) {
    vec2 bend = abs(place.yx) / 6.0;
    return place + place * bend * bend * amount * 40.0;
}

// 1 on the glass, 0 beyond its edge, in between where the edge crosses a pixel. `half_size` is half
// the size of the glass, in the unit of `radius`, its corner radius.
float glass_coverage(vec2 place, vec2 half_size, float radius) {
    vec2 beyond = abs(place) * half_size - (half_size - radius);
    float distance_out = length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - radius;
    float pixel = max(length(vec2(dFdx(distance_out), dFdy(distance_out))), 1e-6);
    return clamp(0.5 - distance_out / pixel, 0.0, 1.0);
}

// The fraction of light that is left: 1 in the middle, 1 - strength in the corners.
float vignette_factor(vec2 place, float strength) {
    return max(0.0, 1.0 - 0.5 * strength * dot(place, place));
}

// sin(pi x) / (pi x): amplitude of a sine with x periods per pixel after averaging over the pixel.
float sinc(float x) {
    float angle = 3.14159265359 * x;
    return abs(angle) < 1e-4 ? 1.0 : sin(angle) / angle;
}

// Brightness of horizontal scanlines: 1 at the crests, 1 - strength in the troughs, and on average
// 1 - strength / 2. The sine is averaged over each pixel. Samples at the pixels' centres would
// alias for periods of a few px.
float scanline_factor(float y_px, float period_px, float strength) {
    float wave = sin(6.28318530718 * y_px / period_px) * sinc(1.0 / period_px);
    return 1.0 - strength * (0.5 + 0.5 * wave);
}

const int interlace_off = 0;
const int interlace_auto = 1;  // on if the source has more lines than a television field
const int interlace_on = 2;

// Whether a source with this number of lines is drawn in two fields. Fields have up to 240 lines at
// 60 per second and up to 288 at 50 (ITU-R BT.470). A frame has twice that number.
bool is_interlaced(int interlace, float lines) {
    bool is_frame = lines > 288.0 && lines <= 576.0;
    return interlace == interlace_on || (interlace == interlace_auto && is_frame);
}

// 0 while the even lines are drawn, 1 while the odd ones are, at 60 fields per second. Interlaced
// patterns number their fields in the same way. `seconds` is the time at the end of the frame.
float field_at(float seconds) {
    return mod(floor(seconds * 60.0 + 1e-3), 2.0);
}

// As scanline_factor, for stripes that follow the lines of a source. Crests are in the middle of
// every `period_lines` lines; in a field, only every second stripe has one. `line` is the position
// in lines from the top of the first one. `line_px` is the height of a line. `field` is 0 or 1, or
// below 0 if the source is not interlaced.
float source_scanline_factor(float line, float period_lines, float line_px, float field,
                             float strength) {
    bool has_fields = field >= 0.0;
    float period = period_lines * (has_fields ? 2.0 : 1.0);
    float crest = has_fields ? 0.25 + 0.5 * field : 0.5;  // of a period
    return scanline_factor((line / period + 0.75 - crest) * period * line_px, period * line_px,
                           strength);
}

#endif
