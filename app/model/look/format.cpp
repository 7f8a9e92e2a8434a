#include "model/look/format.h"

#include <algorithm>

const std::vector<FormatInfo>& all_formats() {
    static const std::vector<FormatInfo> formats{
        {Format::r8, "r8", 1, 1, false},
        {Format::rg8, "rg8", 2, 2, false},
        {Format::rgba8, "rgba8", 4, 4, false},
        {Format::srgb8_alpha8, "srgb8_alpha8", 4, 4, false},
        {Format::rgb10_a2, "rgb10_a2", 4, 4, false},
        {Format::r11f_g11f_b10f, "r11f_g11f_b10f", 3, 4},
        {Format::r16f, "r16f", 1, 2},
        {Format::rg16f, "rg16f", 2, 4},
        {Format::rgba16f, "rgba16f", 4, 8},
        {Format::r32f, "r32f", 1, 4},
        {Format::rg32f, "rg32f", 2, 8},
        {Format::rgba32f, "rgba32f", 4, 16},
        {Format::r32ui, "r32ui", 1, 4, false, true},
        {Format::r8ui, "r8ui", 1, 1, false, true},
        {Format::rg8ui, "rg8ui", 2, 2, false, true},
        {Format::rgba8ui, "rgba8ui", 4, 4, false, true},
        {Format::rgb10_a2ui, "rgb10_a2ui", 4, 4, false, true},
        {Format::r16ui, "r16ui", 1, 2, false, true},
        {Format::rg16ui, "rg16ui", 2, 4, false, true},
        {Format::rgba16ui, "rgba16ui", 4, 8, false, true},
        {Format::rg32ui, "rg32ui", 2, 8, false, true},
        {Format::rgba32ui, "rgba32ui", 4, 16, false, true},
        {Format::r32i, "r32i", 1, 4, false, true, true},
        {Format::r8i, "r8i", 1, 1, false, true, true},
        {Format::rg8i, "rg8i", 2, 2, false, true, true},
        {Format::rgba8i, "rgba8i", 4, 4, false, true, true},
        {Format::r16i, "r16i", 1, 2, false, true, true},
        {Format::rg16i, "rg16i", 2, 4, false, true, true},
        {Format::rgba16i, "rgba16i", 4, 8, false, true, true},
        {Format::rg32i, "rg32i", 2, 8, false, true, true},
        {Format::rgba32i, "rgba32i", 4, 16, false, true, true},
    };
    return formats;
}

const FormatInfo& info_of(Format format) {
    return all_formats()[static_cast<std::size_t>(format)];
}

SampleKind sample_kind_of(Format format) {
    const FormatInfo& info = info_of(format);
    if (!info.is_integer)
        return SampleKind::floating;
    return info.is_signed ? SampleKind::integer : SampleKind::unsigned_integer;
}

std::optional<Format> one_channel_of(Format format) {
    switch (format) {
        case Format::rg8:
        case Format::rgba8:
            return Format::r8;
        case Format::rg16f:
        case Format::rgba16f:
            return Format::r16f;
        case Format::rg32f:
        case Format::rgba32f:
            return Format::r32f;
        default:
            return std::nullopt;
    }
}

std::optional<Format> half_floats_of(Format format) {
    switch (format) {
        case Format::r32f:
            return Format::r16f;
        case Format::rg32f:
            return Format::rg16f;
        case Format::rgba32f:
            return Format::rgba16f;
        default:
            return std::nullopt;
    }
}

std::optional<Format> parse_format(std::string_view name) {
    const auto& formats = all_formats();
    const auto found = std::find_if(formats.begin(), formats.end(),
                                    [&](const FormatInfo& info) { return info.name == name; });
    if (found == formats.end())
        return std::nullopt;
    return found->format;
}
