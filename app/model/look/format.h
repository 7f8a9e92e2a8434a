#pragma once

#include <optional>
#include <string_view>
#include <vector>

/// The texel format of a target.
enum class Format {
    r8,
    rg8,
    rgba8,
    srgb8_alpha8,
    rgb10_a2,
    r11f_g11f_b10f,
    r16f,
    rg16f,
    rgba16f,
    r32f,
    rg32f,
    rgba32f,
    r32ui,
    r8ui,
    rg8ui,
    rgba8ui,
    rgb10_a2ui,
    r16ui,
    rg16ui,
    rgba16ui,
    rg32ui,
    rgba32ui,
    r32i,
    r8i,
    rg8i,
    rgba8i,
    r16i,
    rg16i,
    rgba16i,
    rg32i,
    rgba32i,
};

/// The type that samplers read and shaders write: float, unsigned integer or signed integer.
enum class SampleKind { floating, unsigned_integer, integer };

struct FormatInfo {
    Format format = Format::rgba16f;
    std::string_view name;  // name in look.json
    int channels = 4;
    int bytes = 8;  // per texel
    bool is_float = true;
    bool is_integer = false;
    bool is_signed = false;  // for integer formats
};

const std::vector<FormatInfo>& all_formats();
const FormatInfo& info_of(Format format);
SampleKind sample_kind_of(Format format);
/// The same type with a red channel only; nullopt if there isn't one.
std::optional<Format> one_channel_of(Format format);
/// The same channels as 16-bit floats; nullopt if the format isn't a 32-bit float format.
std::optional<Format> half_floats_of(Format format);
std::optional<Format> parse_format(std::string_view name);
