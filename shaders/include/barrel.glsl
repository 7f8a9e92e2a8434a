// Barrel distortion of a tube's glass, set by a single number, and its inverse. Positions are -1..1
// in x and y, with (0, 0) in the middle. The middle of each side stays in place.
#ifndef AFTERGLOW_BARREL
#define AFTERGLOW_BARREL

// The position on the tube that is shown at `place` of the picture: r' = r ((1 - c) + c r^2). For 0
// <= c < 1 it grows with r everywhere, so it has an inverse. Positions beyond 1 are off the tube.
vec2 barrel_radial(vec2 place, float curvature) {
    return place * (1.0 - curvature + curvature * dot(place, place));
}

// The position in the picture that shows `place` of the tube, by Newton's method. It starts above
// the root, where the curve is steeper. So each step ends between the root and the previous value.
vec2 barrel_radial_inverse(vec2 place, float curvature) {
    float radius = length(place);
    if (radius < 1e-7)
        return place / (1.0 - curvature);
    float root = min(max(radius, 1.0), radius / (1.0 - curvature));
    for (int i = 0; i < 10; ++i) {
        float square = curvature * root * root;
        float miss = root * (1.0 - curvature + square) - radius;
        root -= miss / (1.0 - curvature + 3.0 * square);
    }
    return place * (root / radius);
}

#endif
