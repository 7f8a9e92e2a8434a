#include "formats/mpv_export/mpv_functions.h"

#include <algorithm>
#include <string_view>

namespace {
// Functions are separated by empty lines. Those of the same name stand together.

// The border is transparent black. A linear filter mixes it in within half a texel, as in GL.
constexpr std::string_view readers = R"(vec4 afterglow_linear_edge(sampler2D image, vec2 at) {
    return textureLod(image, at, 0.0);
}

vec4 afterglow_linear_mirror(sampler2D image, vec2 at) {
    return textureLod(image, 1.0 - abs(mod(at, 2.0) - 1.0), 0.0);
}

vec4 afterglow_linear_border(sampler2D image, vec2 at) {
    vec2 size = vec2(textureSize(image, 0));
    vec2 inside = clamp(at * size + 0.5, 0.0, 1.0) * clamp(size - at * size + 0.5, 0.0, 1.0);
    return textureLod(image, at, 0.0) * (inside.x * inside.y);
}

vec4 afterglow_linear_repeat(sampler2D image, vec2 at) {
    ivec2 size = textureSize(image, 0);
    vec2 texel = fract(at) * vec2(size) - 0.5;
    ivec2 a = (ivec2(floor(texel)) + size) % size;
    ivec2 b = (a + 1) % size;
    vec2 part = fract(texel);
    return mix(mix(texelFetch(image, a, 0), texelFetch(image, ivec2(b.x, a.y), 0), part.x),
               mix(texelFetch(image, ivec2(a.x, b.y), 0), texelFetch(image, b, 0), part.x), part.y);
}

vec4 afterglow_nearest_edge(sampler2D image, vec2 at) {
    ivec2 size = textureSize(image, 0);
    return texelFetch(image, clamp(ivec2(floor(at * vec2(size))), ivec2(0), size - 1), 0);
}

vec4 afterglow_nearest_mirror(sampler2D image, vec2 at) {
    return afterglow_nearest_edge(image, 1.0 - abs(mod(at, 2.0) - 1.0));
}

vec4 afterglow_nearest_border(sampler2D image, vec2 at) {
    bool is_inside = all(greaterThanEqual(at, vec2(0.0))) && all(lessThan(at, vec2(1.0)));
    return is_inside ? afterglow_nearest_edge(image, at) : vec4(0.0);
}

vec4 afterglow_nearest_repeat(sampler2D image, vec2 at) {
    return afterglow_nearest_edge(image, fract(at));
}
)";

constexpr std::string_view numbered = R"(float afterglow_level_for(int image, vec2 dx, vec2 dy) {
    vec2 size = vec2(afterglow_size(image));
    return log2(max(max(length(dx * size), length(dy * size)), 1e-6));
}

vec4 afterglow_texture(int image, vec2 at, float bias) {
    return afterglow_read(image, at, afterglow_level_at(image, at) + bias);
}
vec4 afterglow_texture(int image, vec2 at) {
    return afterglow_texture(image, at, 0.0);
}

vec4 afterglow_textureLod(int image, vec2 at, float level) {
    return afterglow_read(image, at, level);
}

vec4 afterglow_textureGrad(int image, vec2 at, vec2 dx, vec2 dy) {
    return afterglow_read(image, at, afterglow_level_for(image, dx, dy));
}

ivec2 afterglow_textureSize(int image, int level) {
    return max(afterglow_size(image) >> level, ivec2(1));
}

vec4 afterglow_textureOffset(int image, vec2 at, ivec2 offset) {
    return afterglow_texture(image, at + vec2(offset) / vec2(afterglow_size(image)));
}

vec4 afterglow_textureLodOffset(int image, vec2 at, float level, ivec2 offset) {
    vec2 size = vec2(afterglow_textureSize(image, int(level)));
    return afterglow_read(image, at + vec2(offset) / size, level);
}

vec4 afterglow_texelFetchOffset(int image, ivec2 texel, int level, ivec2 offset) {
    return afterglow_texelFetch(image, texel + offset, level);
}

vec4 afterglow_textureGather(int image, vec2 at, int component) {
    vec2 size = vec2(afterglow_size(image));
    vec2 first = floor(at * size - 0.5) + 0.5;
    return vec4(afterglow_texel(image, (first + vec2(0.0, 1.0)) / size)[component],
                afterglow_texel(image, (first + vec2(1.0, 1.0)) / size)[component],
                afterglow_texel(image, (first + vec2(1.0, 0.0)) / size)[component],
                afterglow_texel(image, first / size)[component]);
}
vec4 afterglow_textureGather(int image, vec2 at) {
    return afterglow_textureGather(image, at, 0);
}
)";

// The product is what Mesa's software renderer reads. A quotient can differ in the last bit, which
// changes comparisons of texels.
constexpr std::string_view rounding = R"(vec4 afterglow_rounded(vec4 texel) {
    return floor(clamp(texel, 0.0, 1.0) * 255.0 + 0.5) * (1.0 / 255.0);
}

vec4 afterglow_rounded_in_srgb(vec4 texel) {
    vec3 light = clamp(texel.rgb, 0.0, 1.0);
    vec3 shown = mix(1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, light * 12.92,
                     lessThanEqual(light, vec3(0.0031308)));
    vec4 stored = afterglow_rounded(vec4(shown, texel.a));
    return vec4(mix(pow((stored.rgb + 0.055) / 1.055, vec3(2.4)), stored.rgb / 12.92,
                    lessThanEqual(stored.rgb, vec3(0.04045))), stored.a);
}
)";

std::vector<MpvFunction> functions_in(std::string_view text) {
    std::vector<MpvFunction> functions;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find("\n\n"), text.size() - 1) + 1;
        const std::string_view head = text.substr(0, text.find('('));
        functions.push_back(
            {std::string(head.substr(head.find(' ') + 1)), std::string(text.substr(0, end))});
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return functions;
}
}  // namespace

std::vector<MpvFunction> mpv_reader_functions() {
    return functions_in(readers);
}

std::vector<MpvFunction> mpv_numbered_functions() {
    return functions_in(numbered);
}

std::vector<MpvFunction> mpv_rounding_functions() {
    return functions_in(rounding);
}

void add_mpv_calls(const std::vector<MpvFunction>& functions, const std::string& text,
                   std::set<std::string>& wanted) {
    for (const MpvFunction& function : functions)
        if (text.find(function.name + "(") != text.npos)
            wanted.insert(function.name);
}

std::string mpv_function_text(const std::vector<MpvFunction>& functions,
                              std::set<std::string> wanted) {
    std::string text;
    for (auto function = functions.rbegin(); function != functions.rend(); ++function)
        if (wanted.contains(function->name)) {
            add_mpv_calls(functions, function->text, wanted);
            text.insert(0, function->text);
        }
    return text;
}
