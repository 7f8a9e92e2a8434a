#include "formats/stack/conversion_stage.h"

#include "glsl/text/include.h"

#include <fmt/format.h>

namespace {
constexpr const char* conversion = R"(#version 410 core
// {0}
uniform sampler2D image;
in vec2 uv;
out vec4 color;

vec3 converted(vec3 given) {{
    vec3 value = abs(given);
    {1}
    return sign(given) * result;
}}

void main() {{
    vec4 texel = {2};
    color = vec4(converted(texel.rgb), texel.a);
}}
)";
constexpr const char* decode =
    "vec3 result = mix(value / 12.92, pow((value + 0.055) / 1.055, vec3(2.4)), "
    "vec3(greaterThan(value, vec3(0.04045))));";
constexpr const char* encode =
    "vec3 result = mix(value * 12.92, 1.055 * pow(value, vec3(1.0 / 2.4)) - 0.055, "
    "vec3(greaterThan(value, vec3(0.0031308))));";
constexpr const char* keep = "vec3 result = value;";

const char* texel_of(Copied how) {
    switch (how) {
        case Copied::texel_by_texel:
            return "texelFetch(image, ivec2(gl_FragCoord.xy), 0)";
        case Copied::whole:
            return "texture(image, uv)";
        case Copied::upside_down:
            return "texture(image, vec2(uv.x, 1.0 - uv.y))";
    }
    return "";
}
}  // namespace

Stage conversion_stage(Encoding from, Encoding to, Copied how) {
    const bool is_same = from == to;
    const bool encodes = to == Encoding::display;
    return builtin_stage(fmt::format(fmt::runtime(conversion),
                                     is_same   ? "Copies the picture."
                                     : encodes ? "Converts linear light to sRGB."
                                               : "Converts sRGB to linear light.",
                                     is_same ? keep : (encodes ? encode : decode), texel_of(how)));
}
