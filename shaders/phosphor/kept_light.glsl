// Reads the custom tube's stored light, which persistence keeps without a ceiling. Linear light.
// The ceiling is applied here, because beams can be drawn directly onto the stored light. Light is
// interpolated before the ceiling, because a phosphor saturates at each point and not in cells.
#ifndef PHOSPHOR_KEPT_LIGHT
#define PHOSPHOR_KEPT_LIGHT

#include "as_written.glsl"
#include "ceiling.glsl"
#include "color.glsl"
#include "one_color.glsl"

const float largest_half = 65504.0;  // 16-bit storage overflows above it

// Scales all channels so that the brightest is at most `most`. The hue is kept.
vec3 saturated(vec3 light, float most) {
    return light * min(1.0, most / max(brightest_channel(light), 1e-20));
}

// A measured tube's light is already limited.
vec3 below_ceiling(vec3 light) {
    if (has_tube())
        return light;
    float most = has_one_color() ? one_color_ceiling() : ceiling;
    return as_written ? min(light, vec3(most)) : saturated(min(light, largest_half), most);
}

vec3 kept_texel(sampler2D image, ivec2 texel) {
    return below_ceiling(texelFetch(image, texel, 0).rgb);
}

vec3 kept_light(sampler2D image, vec2 at) {
    return below_ceiling(texture(image, at).rgb);
}

#endif
