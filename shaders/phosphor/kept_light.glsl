// What persistence keeps of the custom tube's light, as whoever reads it gets it. Linear light.
// Where the beam is drawn straight onto it, light has not met the ceiling yet: that is done here.
#ifndef PHOSPHOR_KEPT_LIGHT
#define PHOSPHOR_KEPT_LIGHT

#include "as_written.glsl"
#include "ceiling.glsl"
#include "color.glsl"
#include "one_color.glsl"

uniform bool u_drawn_onto;

// The brightest channel reaches the ceiling and takes the others along: the hue stays.
vec3 saturated(vec3 light, float most) {
    return light * min(1.0, most / max(brightest_channel(light), 1e-20));
}

vec3 below_ceiling(vec3 light) {
    const float largest_half = 65504.0;
    float most = has_one_color() ? one_color_ceiling() : ceiling;
    return as_written ? min(light, vec3(most)) : saturated(min(light, largest_half), most);
}

vec3 kept_texel(sampler2D image, ivec2 texel) {
    vec3 light = texelFetch(image, texel, 0).rgb;
    return u_drawn_onto ? below_ceiling(light) : light;
}

// Between texels, and beyond the sides the last ones. A texture's own filter would mix them before
// they meet the ceiling.
vec3 kept_light(sampler2D image, vec2 at) {
    if (!u_drawn_onto)
        return texture(image, at).rgb;
    vec2 size = vec2(textureSize(image, 0));
    vec2 place = at * size - 0.5;
    vec2 corner = clamp(floor(place), vec2(0.0), max(size - 2.0, 0.0));
    vec2 part = clamp(place - corner, vec2(0.0), min(size - 1.0, 1.0));
    if (has_one_color()) {
        vec4 four = min(textureGather(image, (corner + 1.0) / size), vec4(one_color_ceiling()));
        return vec3(mix(mix(four.w, four.z, part.x), mix(four.x, four.y, part.x), part.y), 0.0, 0.0);
    }
    ivec2 texel = ivec2(corner);
    vec3 lower = mix(kept_texel(image, texel), kept_texel(image, texel + ivec2(1, 0)), part.x);
    vec3 upper =
        mix(kept_texel(image, texel + ivec2(0, 1)), kept_texel(image, texel + 1), part.x);
    return mix(lower, upper, part.y);
}

#endif
