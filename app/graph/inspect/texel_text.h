#pragma once

#include "graph/programs/sample_programs.h"

#include <fmt/format.h>

#include <string>

// GLSL for stages that read the texels of any target. `shown` is the sampler and
// `texel_at(position)` returns RGBA. `channels` is a value of Channels, and `chosen(rgba)` returns
// these numbers. A single channel is returned three times.

inline const std::string choosing_text = R"(
uniform int channels;
float luminance(vec3 rgb) { return dot(rgb, vec3(0.2126, 0.7152, 0.0722)); }  // ITU-R BT.709
vec3 chosen(vec4 rgba) {
    if (channels == 0) return rgba.rgb;
    if (channels < 5) return vec3(rgba[channels - 1]);
    return vec3(luminance(rgba.rgb));
}
)";

/// For targets with this kind of numbers.
inline std::string texel_text(SampleKind kind) {
    return fmt::format(
        "{}uniform {}sampler2D shown;\n"
        "vec4 texel_at(ivec2 texel) {{ return vec4(texelFetch(shown, texel, 0)); }}\n",
        choosing_text, glsl_prefix(kind));
}
