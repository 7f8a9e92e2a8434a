// Colour as strength and hue. The strength is the mean of red, green and blue. The hue is the
// relative difference of red and of blue from it, so white has the hue 0. A look that stores light
// as one number stores its colour in two more.
#ifndef VECTOR_BEAM_TINT
#define VECTOR_BEAM_TINT

float strength_of(vec3 color) {
    return color.g + ((color.r - color.g) + (color.b - color.g)) / 3.0;  // exact for white
}

vec2 hue_of(vec3 color) {
    float strength = strength_of(color);
    return strength > 0.0 ? color.rb / strength - 1.0 : vec2(0.0);
}

// The colour of strength 1. Channels near 0 become 0, because the rounding errors of half floats
// would show in bright light.
vec3 color_of(vec2 hue) {
    vec3 color = vec3(1.0 + hue.x, 1.0 - hue.x - hue.y, 1.0 + hue.y);
    return mix(vec3(0.0), color, greaterThan(color, vec3(5e-4)));
}

// The hue of two lights together.
vec2 mixed_hue(float light, vec2 hue, vec2 other_times_hue, float other) {
    float both = light + other;
    return both > 0.0 ? (light * hue + other_times_hue) / both : vec2(0.0);
}

#endif
