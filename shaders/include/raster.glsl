// The raster of a tube: where its lines are, and the spot that draws them.
#ifndef AFTERGLOW_RASTER
#define AFTERGLOW_RASTER

#include "glass.glsl"

// The lines that are drawn in one field. Positions are from the top of the picture, 0..1.
struct Raster {
    float lines;  // in this field
    float first;  // middle of its first line
    float pitch;  // from one of its lines to the next
};

// `place` is the start, pitch and number of the lines of a frame. A field has every second one.
// `field` is 0 or 1, or below 0 without interlacing.
Raster raster_of(vec3 place, float field) {
    if (field < 0.0)
        return Raster(place.z, place.x + 0.5 * place.y, place.y);
    return Raster(floor(0.5 * (place.z + 1.0 - field)), place.x + (0.5 + field) * place.y,
                  2.0 * place.y);
}

// Standard deviation of the spot. It grows with the square root of the beam current, as space charge
// does in the models of crt-royale and of display handbooks, up to a current of 1.
vec3 spot_size(vec3 current, float smallest, float growth) {
    return smallest * (1.0 + growth * sqrt(clamp(current, 0.0, 1.0)));
}

// Light of a spot at a distance from its middle, relative to its light spread evenly over a length
// of 1. It is averaged over a pixel: the pixel's variance adds to that of the spot. The sum over
// pixels stays within 0.8 % of the exact one, because the deviation is at least half a pixel.
vec3 spot_light(vec3 away, vec3 deviation, float pixel) {
    float square = pixel * pixel;
    vec3 narrow = inversesqrt(max(deviation * deviation + square / 12.0, vec3(0.25 * square)));
    vec3 part = away * narrow;
    return 0.3989422804 * narrow * exp(-0.5 * part * part);
}

#endif
