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
/// Added to a border's number: the sampler reads mip levels, and mixes two of them.
inline constexpr int es_mipmapped = 8;
inline constexpr int es_mixes_levels = 16;

inline constexpr std::array es_functions{
    EsFunction{"textureGather", "es_gather", true, false},
    EsFunction{"textureGatherOffset", "es_gather_offset", true, false},
    EsFunction{"textureQueryLod", "es_query_lod", true, false},
    EsFunction{"textureQueryLevels", "es_query_levels", true, false},
    EsFunction{"texture", "es_texture", true, true},
    EsFunction{"textureLod", "es_texture_lod", true, true},
    EsFunction{"textureGrad", "es_texture_grad", true, true},
    EsFunction{"textureOffset", "es_texture_offset", true, true},
    EsFunction{"textureLodOffset", "es_texture_lod_offset", true, true},
    EsFunction{"textureGradOffset", "es_texture_grad_offset", true, true},
    EsFunction{"textureProj", "es_texture_proj", true, true},
    EsFunction{"textureProjLod", "es_texture_proj_lod", true, true},
    EsFunction{"textureProjGrad", "es_texture_proj_grad", true, true},
    EsFunction{"textureProjOffset", "es_texture_proj_offset", true, true},
    EsFunction{"textureProjLodOffset", "es_texture_proj_lod_offset", true, true},
    EsFunction{"textureProjGradOffset", "es_texture_proj_grad_offset", true, true},
    EsFunction{"bitfieldReverse", "es_bitfield_reverse", false, false},
    EsFunction{"bitfieldExtract", "es_bitfield_extract", false, false},
    EsFunction{"bitfieldInsert", "es_bitfield_insert", false, false},
    EsFunction{"bitCount", "es_bit_count", false, false},
    EsFunction{"findLSB", "es_find_lsb", false, false},
    EsFunction{"findMSB", "es_find_msb", false, false},
    EsFunction{"ldexp", "es_ldexp", false, false},
    EsFunction{"packUnorm4x8", "es_pack_unorm", false, false},
    EsFunction{"packSnorm4x8", "es_pack_snorm", false, false},
    EsFunction{"unpackUnorm4x8", "es_unpack_unorm", false, false},
    EsFunction{"unpackSnorm4x8", "es_unpack_snorm", false, false},
};

/// Functions of a sampler that do not depend on how it wraps.
inline constexpr std::array es_texel_functions{"texelFetch", "texelFetchOffset", "textureSize"};

/// Levels of a picture, and the level that a fragment shader reads without a level of its own.
/// OpenGL 4.1, section 3.9.11.
inline constexpr std::string_view es_level_functions = R"(
int es_last_level(sampler2D s)
{
    ivec2 n = textureSize(s, 0);
    return int(log2(float(max(n.x, n.y))) + 0.00001);
}
int es_query_levels(sampler2D s, int wrap) { return wrap < 8 ? 1 : es_last_level(s) + 1; }
float es_lod(sampler2D s, vec2 dx, vec2 dy)
{
    vec2 n = vec2(textureSize(s, 0));
    return log2(max(max(length(dx * n), length(dy * n)), 1e-30));
}
vec2 es_level_of(sampler2D s, int wrap, float lod)
{
    float level = wrap < 8 ? 0.0 : clamp(lod, 0.0, float(es_last_level(s)));
    return vec2(wrap < 16 ? ceil(level + 0.5) - 1.0 : level, lod);
}
)";

inline constexpr std::string_view es_fragment_level_functions = R"(
vec2 es_query_lod(sampler2D s, int wrap, vec2 uv)
{ return es_level_of(s, wrap, es_lod(s, dFdx(uv), dFdy(uv))); }
)";

/// Weights and reads of textures that wrap to a border. A linear filter mixes the outermost texel
/// with the border: its weight falls from 1 to 0 within half a texel on both sides of the edge.
inline constexpr std::string_view es_border_functions = R"(
float es_inside(sampler2D s, int wrap, vec2 uv, int level)
{
    if ((wrap & 7) < 3)
        return 1.0;
    vec2 n = vec2(textureSize(s, level));
    vec2 p = uv * n;
    if ((wrap & 7) == 4)
        return all(greaterThanEqual(p, vec2(0.0))) && all(lessThan(p, n)) ? 1.0 : 0.0;
    vec2 w = clamp(p + 0.5, 0.0, 1.0) * clamp(n - p + 0.5, 0.0, 1.0);
    return w.x * w.y;
}
)";

/// For passes without mip levels: shaders with fewer functions are compiled faster. An offset moves
/// exactly by texels, because some shaders compare the results with 0.
inline constexpr std::string_view es_flat_functions = R"(
vec4 es_texture(sampler2D s, int wrap, vec2 uv)
{ return texture(s, uv) * es_inside(s, wrap, uv, 0); }
vec4 es_texture_lod(sampler2D s, int wrap, vec2 uv, float level)
{ return textureLod(s, uv, level) * es_inside(s, wrap, uv, 0); }
vec4 es_texture_grad(sampler2D s, int wrap, vec2 uv, vec2 dx, vec2 dy)
{ return textureGrad(s, uv, dx, dy) * es_inside(s, wrap, uv, 0); }
vec4 es_border_texel(sampler2D s, ivec2 i)
{
    bool outside = any(lessThan(i, ivec2(0))) || any(greaterThanEqual(i, textureSize(s, 0)));
    return outside ? vec4(0.0) : texelFetch(s, i, 0);
}
vec4 es_texture_offset(sampler2D s, int wrap, vec2 uv, ivec2 offset)
{
    vec2 n = vec2(textureSize(s, 0));
    if ((wrap & 7) < 3)
        return texture(s, uv + vec2(offset) / n);
    if ((wrap & 7) == 4)
        return es_border_texel(s, ivec2(floor(uv * n)) + offset);
    vec2 p = uv * n - 0.5;
    ivec2 i = ivec2(floor(p)) + offset;
    vec4 low = mix(es_border_texel(s, i), es_border_texel(s, i + ivec2(1, 0)), fract(p.x));
    vec4 high = mix(es_border_texel(s, i + ivec2(0, 1)), es_border_texel(s, i + 1), fract(p.x));
    return mix(low, high, fract(p.y));
}
vec4 es_texture_lod_offset(sampler2D s, int wrap, vec2 uv, float level, ivec2 offset)
{ return es_texture_offset(s, wrap, uv, offset); }
)";

/// A bias exists in fragment shaders only.
inline constexpr std::string_view es_flat_bias_function = R"(
vec4 es_texture(sampler2D s, int wrap, vec2 uv, float bias)
{ return texture(s, uv, bias) * es_inside(s, wrap, uv, 0); }
)";

/// The weights of two mip levels are mixed. Their reads are not, which would differ only where both
/// are near an edge.
inline constexpr std::string_view es_mipmap_functions = R"(
float es_inside_levels(sampler2D s, int wrap, vec2 uv, float lod)
{
    float level = es_level_of(s, wrap, lod).x;
    return mix(es_inside(s, wrap, uv, int(level)), es_inside(s, wrap, uv, int(ceil(level))),
               fract(level));
}
vec4 es_texture_lod(sampler2D s, int wrap, vec2 uv, float level)
{ return textureLod(s, uv, level) * es_inside_levels(s, wrap, uv, level); }
vec4 es_texture_grad(sampler2D s, int wrap, vec2 uv, vec2 dx, vec2 dy)
{ return textureGrad(s, uv, dx, dy) * es_inside_levels(s, wrap, uv, es_lod(s, dx, dy)); }
vec4 es_texture_lod_offset(sampler2D s, int wrap, vec2 uv, float level, ivec2 offset)
{
    vec2 n = vec2(textureSize(s, int(es_level_of(s, wrap, level).x)));
    return es_texture_lod(s, wrap, uv + vec2(offset) / n, level);
}
)";

/// Without a level of its own, a vertex shader reads level 0.
inline constexpr std::string_view es_vertex_mipmap_functions = R"(
vec4 es_texture(sampler2D s, int wrap, vec2 uv)
{ return texture(s, uv) * es_inside(s, wrap, uv, 0); }
)";

inline constexpr std::string_view es_fragment_mipmap_functions = R"(
vec4 es_texture(sampler2D s, int wrap, vec2 uv)
{ return texture(s, uv) * es_inside_levels(s, wrap, uv, es_lod(s, dFdx(uv), dFdy(uv))); }
vec4 es_texture(sampler2D s, int wrap, vec2 uv, float bias)
{
    float lod = es_lod(s, dFdx(uv), dFdy(uv)) + bias;
    return texture(s, uv, bias) * es_inside_levels(s, wrap, uv, lod);
}
)";

inline constexpr std::string_view es_mipmap_offset_function = R"(
vec4 es_texture_offset(sampler2D s, int wrap, vec2 uv, ivec2 offset)
{ return es_texture(s, wrap, uv + vec2(offset) / vec2(textureSize(s, 0))); }
)";

inline constexpr std::string_view es_bias_functions = R"(
vec4 es_texture_offset(sampler2D s, int wrap, vec2 uv, ivec2 offset, float bias)
{ return es_texture(s, wrap, uv + vec2(offset) / vec2(textureSize(s, 0)), bias); }
vec4 es_texture_proj(sampler2D s, int wrap, vec3 p, float bias)
{ return es_texture(s, wrap, p.xy / p.z, bias); }
vec4 es_texture_proj(sampler2D s, int wrap, vec4 p, float bias)
{ return es_texture(s, wrap, p.xy / p.w, bias); }
)";

/// Reads that are made of those above.
inline constexpr std::string_view es_composed_functions = R"(
vec4 es_texture_grad_offset(sampler2D s, int wrap, vec2 uv, vec2 dx, vec2 dy, ivec2 offset)
{ return es_texture_grad(s, wrap, uv + vec2(offset) / vec2(textureSize(s, 0)), dx, dy); }
vec4 es_texture_proj(sampler2D s, int wrap, vec3 p) { return es_texture(s, wrap, p.xy / p.z); }
vec4 es_texture_proj(sampler2D s, int wrap, vec4 p) { return es_texture(s, wrap, p.xy / p.w); }
vec4 es_texture_proj_lod(sampler2D s, int wrap, vec3 p, float level)
{ return es_texture_lod(s, wrap, p.xy / p.z, level); }
vec4 es_texture_proj_lod(sampler2D s, int wrap, vec4 p, float level)
{ return es_texture_lod(s, wrap, p.xy / p.w, level); }
vec4 es_texture_proj_grad(sampler2D s, int wrap, vec3 p, vec2 dx, vec2 dy)
{ return es_texture_grad(s, wrap, p.xy / p.z, dx, dy); }
vec4 es_texture_proj_grad(sampler2D s, int wrap, vec4 p, vec2 dx, vec2 dy)
{ return es_texture_grad(s, wrap, p.xy / p.w, dx, dy); }
vec4 es_texture_proj_offset(sampler2D s, int wrap, vec3 p, ivec2 offset)
{ return es_texture_offset(s, wrap, p.xy / p.z, offset); }
vec4 es_texture_proj_offset(sampler2D s, int wrap, vec4 p, ivec2 offset)
{ return es_texture_offset(s, wrap, p.xy / p.w, offset); }
vec4 es_texture_proj_lod_offset(sampler2D s, int wrap, vec3 p, float level, ivec2 offset)
{ return es_texture_lod_offset(s, wrap, p.xy / p.z, level, offset); }
vec4 es_texture_proj_lod_offset(sampler2D s, int wrap, vec4 p, float level, ivec2 offset)
{ return es_texture_lod_offset(s, wrap, p.xy / p.w, level, offset); }
vec4 es_texture_proj_grad_offset(sampler2D s, int wrap, vec3 p, vec2 dx, vec2 dy, ivec2 offset)
{ return es_texture_grad_offset(s, wrap, p.xy / p.z, dx, dy, offset); }
vec4 es_texture_proj_grad_offset(sampler2D s, int wrap, vec4 p, vec2 dx, vec2 dy, ivec2 offset)
{ return es_texture_grad_offset(s, wrap, p.xy / p.w, dx, dy, offset); }
)";

/// Pictures of integers have no filter and no mip levels. The place of NUMBERS is for i and u.
inline constexpr std::string_view es_integer_border_functions = R"(
bool es_is_outside(NUMBERSsampler2D s, int wrap, vec2 uv)
{
    vec2 p = uv * vec2(textureSize(s, 0));
    bool outside = any(lessThan(p, vec2(0.0))) || any(greaterThanEqual(p, vec2(textureSize(s, 0))));
    return (wrap & 7) >= 3 && outside;
}
NUMBERSvec4 es_texture(NUMBERSsampler2D s, int wrap, vec2 uv)
{ return es_is_outside(s, wrap, uv) ? NUMBERSvec4(0) : texture(s, uv); }
NUMBERSvec4 es_texture_lod(NUMBERSsampler2D s, int wrap, vec2 uv, float level)
{ return es_is_outside(s, wrap, uv) ? NUMBERSvec4(0) : textureLod(s, uv, 0.0); }
)";

inline constexpr std::string_view es_gather_functions = R"(
int es_wrapped(int i, int n, int wrap)
{
    if ((wrap & 7) == 1)
        return i - n * int(floor(float(i) / float(n)));
    if ((wrap & 7) == 2) {
        int k = i - 2 * n * int(floor(float(i) / float(2 * n)));
        return k < n ? k : 2 * n - 1 - k;
    }
    return clamp(i, 0, n - 1);
}
float es_texel(sampler2D s, int wrap, ivec2 i, int component)
{
    ivec2 n = textureSize(s, 0);
    bool outside = any(lessThan(i, ivec2(0))) || any(greaterThanEqual(i, n));
    if ((wrap & 7) >= 3 && outside)
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

/// For unsigned and signed numbers.
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
int es_find_lsb(uint v) { return v == 0u ? -1 : es_bit_count((v & (~v + 1u)) - 1u); }
int es_find_lsb(int v) { return es_find_lsb(uint(v)); }
int es_find_msb(uint v)
{
    for (uint shift = 1u; shift < 32u; shift <<= 1u)
        v |= v >> shift;
    return es_bit_count(v) - 1;
}
int es_find_msb(int v) { return es_find_msb(uint(v < 0 ? ~v : v)); }
)";

/// The same for vectors. NUMBERS are i and u.
inline constexpr std::string_view es_bit_vector_functions = R"(
NUMBERSvec2 es_bitfield_reverse(NUMBERSvec2 v)
{ return NUMBERSvec2(es_bitfield_reverse(v.x), es_bitfield_reverse(v.y)); }
NUMBERSvec3 es_bitfield_reverse(NUMBERSvec3 v)
{ return NUMBERSvec3(es_bitfield_reverse(v.xy), es_bitfield_reverse(v.z)); }
NUMBERSvec4 es_bitfield_reverse(NUMBERSvec4 v)
{ return NUMBERSvec4(es_bitfield_reverse(v.xy), es_bitfield_reverse(v.zw)); }
NUMBERSvec2 es_bitfield_extract(NUMBERSvec2 v, int o, int b)
{ return NUMBERSvec2(es_bitfield_extract(v.x, o, b), es_bitfield_extract(v.y, o, b)); }
NUMBERSvec3 es_bitfield_extract(NUMBERSvec3 v, int o, int b)
{ return NUMBERSvec3(es_bitfield_extract(v.xy, o, b), es_bitfield_extract(v.z, o, b)); }
NUMBERSvec4 es_bitfield_extract(NUMBERSvec4 v, int o, int b)
{ return NUMBERSvec4(es_bitfield_extract(v.xy, o, b), es_bitfield_extract(v.zw, o, b)); }
NUMBERSvec2 es_bitfield_insert(NUMBERSvec2 v, NUMBERSvec2 w, int o, int b)
{ return NUMBERSvec2(es_bitfield_insert(v.x, w.x, o, b), es_bitfield_insert(v.y, w.y, o, b)); }
NUMBERSvec3 es_bitfield_insert(NUMBERSvec3 v, NUMBERSvec3 w, int o, int b)
{ return NUMBERSvec3(es_bitfield_insert(v.xy, w.xy, o, b), es_bitfield_insert(v.z, w.z, o, b)); }
NUMBERSvec4 es_bitfield_insert(NUMBERSvec4 v, NUMBERSvec4 w, int o, int b)
{ return NUMBERSvec4(es_bitfield_insert(v.xy, w.xy, o, b), es_bitfield_insert(v.zw, w.zw, o, b)); }
ivec2 es_bit_count(NUMBERSvec2 v) { return ivec2(es_bit_count(v.x), es_bit_count(v.y)); }
ivec3 es_bit_count(NUMBERSvec3 v) { return ivec3(es_bit_count(v.xy), es_bit_count(v.z)); }
ivec4 es_bit_count(NUMBERSvec4 v) { return ivec4(es_bit_count(v.xy), es_bit_count(v.zw)); }
ivec2 es_find_lsb(NUMBERSvec2 v) { return ivec2(es_find_lsb(v.x), es_find_lsb(v.y)); }
ivec3 es_find_lsb(NUMBERSvec3 v) { return ivec3(es_find_lsb(v.xy), es_find_lsb(v.z)); }
ivec4 es_find_lsb(NUMBERSvec4 v) { return ivec4(es_find_lsb(v.xy), es_find_lsb(v.zw)); }
ivec2 es_find_msb(NUMBERSvec2 v) { return ivec2(es_find_msb(v.x), es_find_msb(v.y)); }
ivec3 es_find_msb(NUMBERSvec3 v) { return ivec3(es_find_msb(v.xy), es_find_msb(v.z)); }
ivec4 es_find_msb(NUMBERSvec4 v) { return ivec4(es_find_msb(v.xy), es_find_msb(v.zw)); }
)";

/// GLSL 4.10, section 8.4, and a product with a power of two.
inline constexpr std::string_view es_pack_functions = R"(
uint es_pack_bytes(uvec4 v) { return v.x | (v.y << 8u) | (v.z << 16u) | (v.w << 24u); }
uvec4 es_bytes(uint v) { return (uvec4(v) >> uvec4(0u, 8u, 16u, 24u)) & 255u; }
uint es_pack_unorm(vec4 v) { return es_pack_bytes(uvec4(round(clamp(v, 0.0, 1.0) * 255.0))); }
uint es_pack_snorm(vec4 v)
{ return es_pack_bytes(uvec4(ivec4(round(clamp(v, -1.0, 1.0) * 127.0))) & 255u); }
vec4 es_unpack_unorm(uint v) { return vec4(es_bytes(v)) / 255.0; }
vec4 es_unpack_snorm(uint v)
{ return clamp(vec4(ivec4(es_bytes(v) << 24u) >> 24) / 127.0, -1.0, 1.0); }
float es_ldexp(float x, int e) { return x * exp2(float(e)); }
vec2 es_ldexp(vec2 x, ivec2 e) { return x * exp2(vec2(e)); }
vec3 es_ldexp(vec3 x, ivec3 e) { return x * exp2(vec3(e)); }
vec4 es_ldexp(vec4 x, ivec4 e) { return x * exp2(vec4(e)); }
)";
