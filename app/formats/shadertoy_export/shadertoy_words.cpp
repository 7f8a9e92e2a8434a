#include "formats/shadertoy_export/shadertoy_words.h"

#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace {
constexpr auto site_words = std::to_array<std::string_view>(
    {"iResolution", "iTime", "iGlobalTime", "iTimeDelta", "iFrameRate", "iFrame", "iChannelTime",
     "iChannelResolution", "iMouse", "iDate", "iSampleRate", "iChannel0", "iChannel1", "iChannel2",
     "iChannel3", "mainImage", "HW_PERFORMANCE"});

constexpr auto function_words = std::to_array<std::string_view>(
    {"image_at",          "image_lod",   "image_fetch", "image_gather",    "image_size",
     "display_to_linear", "bordered",    "level_at",    "level_size",      "last_level",
     "first_level",       "level_place", "level_tap",   "level_texel",     "base_texel",
     "read_level",        "stored",      "draw_pass",   "shadertoy_color", "shadertoy_place"});

constexpr auto unusable = std::to_array<std::string_view>(
    {"textureOffset", "textureLodOffset", "texelFetchOffset", "textureGrad", "textureProj",
     "textureProjLod", "textureQueryLod", "textureQueryLevels", "samplerCube", "isampler2D",
     "usampler2D", "sampler3D"});

}  // namespace

bool is_shadertoy_word(std::string_view name) {
    return std::ranges::find(site_words, name) != site_words.end();
}

std::set<std::string, std::less<>> shadertoy_reserved_names() {
    std::set<std::string, std::less<>> names;
    for (const std::string_view word : site_words)
        names.emplace(word);
    for (const std::string_view word : function_words)
        names.emplace(word);
    return names;
}

std::string unusable_word(const GlslWords& words) {
    for (const std::string_view word : unusable)
        if (words.contains(word))
            return std::string(word);
    return {};
}

std::string stored_value(Format format) {
    constexpr const char* rounded = "floor(clamp(color, 0.0, 1.0) * 255.0 + 0.5) * (1.0 / 255.0)";
    switch (format) {
        case Format::r8:
            return fmt::format("vec4(({}).r, 0.0, 0.0, 1.0)", rounded);
        case Format::rg8:
            return fmt::format("vec4(({}).rg, 0.0, 1.0)", rounded);
        case Format::rgba8:
            return rounded;
        case Format::r16f:
        case Format::r32f:
            return "vec4(color.r, 0.0, 0.0, 1.0)";
        case Format::rg16f:
        case Format::rg32f:
            return "vec4(color.rg, 0.0, 1.0)";
        case Format::r11f_g11f_b10f:
            return "vec4(max(color.rgb, 0.0), 1.0)";
        default:
            return {};
    }
}

bool calls_with_bias(std::string_view text) {
    const Tokens tokens = scan(text);
    for (std::size_t i = 0; i + 1 < tokens.all.size(); ++i) {
        if (!tokens.all[i].is("texture") || !tokens.all[i + 1].is("("))
            continue;
        int depth = 0;
        int commas = 0;
        for (std::size_t k = i + 1; k < tokens.all.size(); ++k) {
            const Token& token = tokens.all[k];
            depth += token.is("(") || token.is("[") ? 1 : token.is(")") || token.is("]") ? -1 : 0;
            commas += depth == 1 && token.is(",") ? 1 : 0;
            if (depth == 0)
                break;
        }
        if (commas > 1)
            return true;
    }
    return false;
}
