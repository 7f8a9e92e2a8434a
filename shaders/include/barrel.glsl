// Barrel: the curve of a tube's glass that a single number sets, and its inverse. Places are -1..1 in
// x and y, (0, 0) in the middle. The middles of the sides stay where they are.
#ifndef AFTERGLOW_BARREL
#define AFTERGLOW_BARREL

// The place on the tube that shows at `place` of the picture: r' = r ((1 - c) + c r^2). For c from 0
// to below 1 it grows with r everywhere, so that it can be undone. Places beyond 1 lie off the tube.
vec2 barrel_radial(vec2 place, float curvature) {
    return place * (1.0 - curvature + curvature * dot(place, place));
}

// Where a place of the tube shows in the picture, by Newton's method. It starts beyond the root, where
// the curve is steeper, so each step lands between the root and where it was.
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
