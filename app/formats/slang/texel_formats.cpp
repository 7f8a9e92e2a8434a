#include "formats/slang/texel_formats.h"

#include <algorithm>
#include <array>

namespace {
struct FormatName {
    std::string_view name;
    Format format;
};
constexpr std::array format_names{FormatName{"R8_UNORM", Format::r8},
                                  FormatName{"R8G8_UNORM", Format::rg8},
                                  FormatName{"R8G8B8A8_UNORM", Format::rgba8},
                                  FormatName{"R8G8B8A8_SRGB", Format::srgb8_alpha8},
                                  FormatName{"A2B10G10R10_UNORM_PACK32", Format::rgb10_a2},
                                  FormatName{"R16_SFLOAT", Format::r16f},
                                  FormatName{"R16G16_SFLOAT", Format::rg16f},
                                  FormatName{"R16G16B16A16_SFLOAT", Format::rgba16f},
                                  FormatName{"R32_SFLOAT", Format::r32f},
                                  FormatName{"R32G32_SFLOAT", Format::rg32f},
                                  FormatName{"R32G32B32A32_SFLOAT", Format::rgba32f},
                                  FormatName{"R32_UINT", Format::r32ui},
                                  FormatName{"R8_UINT", Format::r8ui},
                                  FormatName{"R8G8_UINT", Format::rg8ui},
                                  FormatName{"R8G8B8A8_UINT", Format::rgba8ui},
                                  FormatName{"A2B10G10R10_UINT_PACK32", Format::rgb10_a2ui},
                                  FormatName{"R16_UINT", Format::r16ui},
                                  FormatName{"R16G16_UINT", Format::rg16ui},
                                  FormatName{"R16G16B16A16_UINT", Format::rgba16ui},
                                  FormatName{"R32G32_UINT", Format::rg32ui},
                                  FormatName{"R32G32B32A32_UINT", Format::rgba32ui},
                                  FormatName{"R32_SINT", Format::r32i},
                                  FormatName{"R8_SINT", Format::r8i},
                                  FormatName{"R8G8_SINT", Format::rg8i},
                                  FormatName{"R8G8B8A8_SINT", Format::rgba8i},
                                  FormatName{"R16_SINT", Format::r16i},
                                  FormatName{"R16G16_SINT", Format::rg16i},
                                  FormatName{"R16G16B16A16_SINT", Format::rgba16i},
                                  FormatName{"R32G32_SINT", Format::rg32i},
                                  FormatName{"R32G32B32A32_SINT", Format::rgba32i}};
}  // namespace

std::optional<Format> slang_format(std::string_view name) {
    const auto* const found = std::ranges::find(format_names, name, &FormatName::name);
    return found == format_names.end() ? std::nullopt : std::optional(found->format);
}

std::string_view slang_format_name(Format format) {
    const auto* const found = std::ranges::find(format_names, format, &FormatName::format);
    return found == format_names.end() ? std::string_view("R8G8B8A8_UNORM") : found->name;
}
