#include "formats/shadertoy_export/shadertoy_levels.h"

#include <fmt/format.h>

namespace {
// Of Buffer A. A texel of the last one is a sum of 64 x 64 texels.
constexpr int stored_levels = 6;

// Each level is made like GPUs make it: from four texels of the next larger one, at the middle of
// the new texel. So a texel of level k is a sum over 2^k paths on each side.
constexpr const char* level_functions_text = R"(
// Mip levels of the picture are in Buffer A: the first at the bottom left, smaller ones in a column
// at its right. Levels before the first are larger than the buffer, so they are not stored.
ivec2 level_size(int level) {{
    return max(ivec2(iChannelResolution[{channel}].xy) >> level, 1);
}}

int last_level(int most) {{
    int level = 0;
    while (level < most && level_size(level) != ivec2(1))
        ++level;
    return level;
}}

int first_level() {{
    int level = 1;
    while (level < {stored} &&
           any(greaterThan(level_size(level) + ivec2(level_size(level + 1).x, 0),
                           ivec2(iResolution.xy))))
        ++level;
    return level;
}}

ivec2 level_place(int level, int first) {{
    ivec2 place = ivec2(level > first ? level_size(first).x : 0, 0);
    for (int k = first + 1; k < level; ++k)
        place.y += level_size(k).y;
    return place;
}}

// One side of a texel of a mip level: the texel of a larger level `base` at the end of a path through
// the levels between them, and its weight. A bit of the path chooses the lower or the higher of two
// texels.
vec2 level_tap(int at, int level, int base, int path, int size) {{
    float weight = 1.0;
    for (int k = level; k > base; --k) {{
        int larger = max(size >> (k - 1), 1);
        float place = (float(at) + 0.5) * float(larger) / float(max(size >> k, 1)) - 0.5;
        int high = (path >> (k - 1 - base)) & 1;
        weight *= high == 1 ? fract(place) : 1.0 - fract(place);
        at = clamp(int(floor(place)) + high, 0, larger - 1);
    }}
    return vec2(at, weight);
}}

vec4 base_texel(ivec2 at, int base) {{
    return {base};
}}

vec4 level_texel(ivec2 at, int level, int base) {{
    ivec2 size = level_size(0);
    int paths = 1 << (level - base);
    vec4 sum = vec4(0.0);
    for (int y = 0; y < paths; ++y) {{
        vec2 row = level_tap(at.y, level, base, y, size.y);
        for (int x = 0; x < paths; ++x) {{
            vec2 column = level_tap(at.x, level, base, x, size.x);
            sum += column.y * row.y * base_texel(ivec2(int(column.x), int(row.x)), base);
        }}
    }}
    return sum;
}}
)";

constexpr const char* level_reader_text = R"(
vec4 read_level(vec2 at, int level) {{
    level = min(level, last_level({last}));
    vec2 size = vec2(level_size(level));
    vec2 place = clamp(at * size, vec2(0.5), size - 0.5);
    int first = first_level();
    if (level >= first && level <= {stored})
        return textureLod(iChannel{channel},
                          (place + vec2(level_place(level, first))) / iResolution.xy, 0.0);
    ivec2 texel = ivec2(floor(place - 0.5));
    vec2 part = fract(place - 0.5);
    int base = level < first ? 0 : {stored};
    vec4 lower = mix(level_texel(texel, level, base),
                     level_texel(texel + ivec2(1, 0), level, base), part.x);
    vec4 upper = mix(level_texel(texel + ivec2(0, 1), level, base),
                     level_texel(texel + 1, level, base), part.x);
    return mix(lower, upper, part.y);
}}
)";

constexpr const char* level_entry_text = R"(
void mainImage(out vec4 shadertoy_color, in vec2 shadertoy_place) {{
    shadertoy_color = vec4(0.0);
    int first = first_level();
    for (int level = first; level <= last_level({}); ++level) {{
        ivec2 texel = ivec2(shadertoy_place) - level_place(level, first);
        bool is_inside = all(greaterThanEqual(texel, ivec2(0))) &&
                         all(lessThan(texel, level_size(level)));
        if (is_inside)
            shadertoy_color = level_texel(texel, level, 0);
    }}
}}
)";
}  // namespace

std::string shadertoy_level_functions(int channel, const std::string& texel) {
    return fmt::format(level_functions_text, fmt::arg("channel", channel),
                       fmt::arg("stored", stored_levels), fmt::arg("base", texel + "(at)"));
}

std::string shadertoy_level_reader(int channel, const std::string& texel, int buffer) {
    const std::string base = fmt::format(
        "base == 0 ? {}(at)\n"
        "                     : texelFetch(iChannel{}, at + level_place(base, first_level()), 0)",
        texel, buffer);
    return fmt::format(level_functions_text, fmt::arg("channel", channel),
                       fmt::arg("stored", stored_levels), fmt::arg("base", base)) +
           fmt::format(level_reader_text, fmt::arg("channel", buffer),
                       fmt::arg("stored", stored_levels), fmt::arg("last", shadertoy_last_level));
}

std::string shadertoy_level_entry() {
    return fmt::format(level_entry_text, stored_levels);
}
