// The glass of a tube: its curve, its edge, its dark corners, and lines across it.
// Places on the glass are -1..1 in x and y, (0, 0) in the middle.
#ifndef AFTERGLOW_GLASS
#define AFTERGLOW_GLASS

// Barrel: the place on the tube that shows at `place` of the picture. The middle of each side stays,
// corners are pushed out by `amount` * 40/36 of themselves.
vec2 barrel(vec2 place, float amount) {
    vec2 bend = abs(place.yx) / 6.0;
    return place + place * bend * bend * amount * 40.0;
}

// 1 on the glass, 0 beyond its edge, in between where the edge cuts a pixel. `half_size` is the
// glass from the middle to its sides, in the unit of `radius` (of its corners).
float glass_coverage(vec2 place, vec2 half_size, float radius) {
    vec2 beyond = abs(place) * half_size - (half_size - radius);
    float distance_out = length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - radius;
    float pixel = max(length(vec2(dFdx(distance_out), dFdy(distance_out))), 1e-6);
    return clamp(0.5 - distance_out / pixel, 0.0, 1.0);
}

// The share of light that is left: 1 in the middle, 1 - strength in the corners.
float vignette_factor(vec2 place, float strength) {
    return max(0.0, 1.0 - 0.5 * strength * dot(place, place));
}

// sin(pi x) / (pi x): what is left of a ripple of x periods a pixel, averaged over the pixel.
float sinc(float x) {
    float angle = 3.14159265359 * x;
    return abs(angle) < 1e-4 ? 1.0 : sin(angle) / angle;
}

// A ripple of brightness down the picture: 1 at its crests, 1 - strength in its troughs, in the mean
// 1 - strength / 2. The sine is averaged over each pixel and not sampled in its middle, where
// periods of a few px would turn into other ones.
float scanline_factor(float y_px, float period_px, float strength) {
    float wave = sin(6.28318530718 * y_px / period_px) * sinc(1.0 / period_px);
    return 1.0 - strength * (0.5 + 0.5 * wave);
}

#endif
