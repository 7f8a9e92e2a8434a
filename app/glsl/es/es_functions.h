#pragma once

#include <array>
#include <string_view>

/// A function that GLSL ES 3.00 lacks.
struct EsFunction {
    std::string_view name;      // in GLSL 4.10
    std::string_view replaced;  // name of its replacement
    bool reads_sampler;         // has a sampler and how it wraps as its first two parameters
    bool is_of_border;          // only needed by passes with a sampler that wraps to a border
};

/// How a sampler wraps, as the shaders get it.
enum class EsWrap { edge = 0, repeat = 1, mirror = 2, linear_border = 3, nearest_border = 4 };

inline constexpr std::array es_functions{
    EsFunction{"textureGather", "es_gather", true, false},
    EsFunction{"textureGatherOffset", "es_gather_offset", true, false},
    EsFunction{"texture", "es_texture", true, true},
    EsFunction{"textureLod", "es_texture_lod", true, true},
    EsFunction{"textureGrad", "es_texture_grad", true, true},
    EsFunction{"textureOffset", "es_texture_offset", true, true},
    EsFunction{"textureLodOffset", "es_texture_lod_offset", true, true},
    EsFunction{"bitfieldReverse", "es_bitfield_reverse", false, false},
    EsFunction{"bitfieldExtract", "es_bitfield_extract", false, false},
    EsFunction{"bitfieldInsert", "es_bitfield_insert", false, false},
    EsFunction{"bitCount", "es_bit_count", false, false},
};

/// Weights and reads of textures that wrap to a border. A linear filter mixes the outermost texel
/// with the border: its weight falls from 1 to 0 within half a texel on both sides of the edge.
inline constexpr std::string_view es_border_functions = R"(
float es_inside(sampler2D s, int wrap, vec2 uv, float level)
{
    if (wrap < 3)
        return 1.0;
    vec2 n = vec2(textureSize(s, int(level + 0.5)));
    vec2 p = uv * n;
    if (wrap == 4)
        return all(greaterThanEqual(p, vec2(0.0))) && all(lessThan(p, n)) ? 1.0 : 0.0;
    vec2 w = clamp(p + 0.5, 0.0, 1.0) * clamp(n - p + 0.5, 0.0, 1.0);
    return w.x * w.y;
}
vec4 es_texture(sampler2D s, int wrap, vec2 uv)
{ return texture(s, uv) * es_inside(s, wrap, uv, 0.0); }
vec4 es_texture_lod(sampler2D s, int wrap, vec2 uv, float level)
{ return textureLod(s, uv, level) * es_inside(s, wrap, uv, max(level, 0.0)); }
vec4 es_texture_grad(sampler2D s, int wrap, vec2 uv, vec2 dx, vec2 dy)
{ return textureGrad(s, uv, dx, dy) * es_inside(s, wrap, uv, 0.0); }
vec4 es_texture_offset(sampler2D s, int wrap, vec2 uv, ivec2 offset)
{ return es_texture(s, wrap, uv + vec2(offset) / vec2(textureSize(s, 0))); }
vec4 es_texture_lod_offset(sampler2D s, int wrap, vec2 uv, float level, ivec2 offset)
{ return es_texture_lod(s, wrap, uv + vec2(offset) / vec2(textureSize(s, int(level + 0.5))), level); }
)";

/// A bias exists in fragment shaders only.
inline constexpr std::string_view es_bias_function = R"(
vec4 es_texture(sampler2D s, int wrap, vec2 uv, float bias)
{ return texture(s, uv, bias) * es_inside(s, wrap, uv, 0.0); }
)";

inline constexpr std::string_view es_gather_functions = R"(
int es_wrapped(int i, int n, int wrap)
{
    if (wrap == 1)
        return i - n * int(floor(float(i) / float(n)));
    if (wrap == 2) {
        int k = i - 2 * n * int(floor(float(i) / float(2 * n)));
        return k < n ? k : 2 * n - 1 - k;
    }
    return clamp(i, 0, n - 1);
}
float es_texel(sampler2D s, int wrap, ivec2 i, int component)
{
    ivec2 n = textureSize(s, 0);
    bool outside = any(lessThan(i, ivec2(0))) || any(greaterThanEqual(i, n));
    if (wrap >= 3 && outside)
        return 0.0;
    return texelFetch(s, ivec2(es_wrapped(i.x, n.x, wrap), es_wrapped(i.y, n.y, wrap)), 0)[component];
}
vec4 es_gather_offset(sampler2D s, int wrap, vec2 uv, ivec2 offset, int component)
{
    ivec2 i = ivec2(floor(uv * vec2(textureSize(s, 0)) - 0.5)) + offset;
    return vec4(es_texel(s, wrap, i + ivec2(0, 1), component),
                es_texel(s, wrap, i + ivec2(1, 1), component),
                es_texel(s, wrap, i + ivec2(1, 0), component),
                es_texel(s, wrap, i, component));
}
vec4 es_gather_offset(sampler2D s, int wrap, vec2 uv, ivec2 offset)
{ return es_gather_offset(s, wrap, uv, offset, 0); }
vec4 es_gather(sampler2D s, int wrap, vec2 uv, int component)
{ return es_gather_offset(s, wrap, uv, ivec2(0), component); }
vec4 es_gather(sampler2D s, int wrap, vec2 uv)
{ return es_gather_offset(s, wrap, uv, ivec2(0), 0); }
)";

/// For unsigned and signed numbers. The vectors are those of Sobol sequences.
inline constexpr std::string_view es_bit_functions = R"(
uint es_bitfield_reverse(uint v)
{
    v = ((v >> 1u) & 0x55555555u) | ((v & 0x55555555u) << 1u);
    v = ((v >> 2u) & 0x33333333u) | ((v & 0x33333333u) << 2u);
    v = ((v >> 4u) & 0x0F0F0F0Fu) | ((v & 0x0F0F0F0Fu) << 4u);
    v = ((v >> 8u) & 0x00FF00FFu) | ((v & 0x00FF00FFu) << 8u);
    return (v >> 16u) | (v << 16u);
}
int es_bitfield_reverse(int v) { return int(es_bitfield_reverse(uint(v))); }
uvec2 es_bitfield_reverse(uvec2 v)
{ return uvec2(es_bitfield_reverse(v.x), es_bitfield_reverse(v.y)); }
uvec3 es_bitfield_reverse(uvec3 v) { return uvec3(es_bitfield_reverse(v.xy), es_bitfield_reverse(v.z)); }
uvec4 es_bitfield_reverse(uvec4 v) { return uvec4(es_bitfield_reverse(v.xy), es_bitfield_reverse(v.zw)); }
uint es_bit_mask(int bits) { return bits >= 32 ? 0xFFFFFFFFu : (1u << uint(bits)) - 1u; }
uint es_bitfield_extract(uint v, int offset, int bits)
{ return bits == 0 ? 0u : (v >> uint(offset)) & es_bit_mask(bits); }
int es_bitfield_extract(int v, int offset, int bits)
{ return bits == 0 ? 0 : (v << uint(32 - offset - bits)) >> uint(32 - bits); }
uint es_bitfield_insert(uint v, uint insert, int offset, int bits)
{
    if (bits == 0)
        return v;
    uint mask = es_bit_mask(bits) << uint(offset);
    return (v & ~mask) | ((insert << uint(offset)) & mask);
}
int es_bitfield_insert(int v, int insert, int offset, int bits)
{ return int(es_bitfield_insert(uint(v), uint(insert), offset, bits)); }
int es_bit_count(uint v)
{
    v = v - ((v >> 1u) & 0x55555555u);
    v = (v & 0x33333333u) + ((v >> 2u) & 0x33333333u);
    return int((((v + (v >> 4u)) & 0x0F0F0F0Fu) * 0x01010101u) >> 24u);
}
int es_bit_count(int v) { return es_bit_count(uint(v)); }
)";
