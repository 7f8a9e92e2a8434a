#include "ui/frame/fonts.h"

#include "base/font_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace {
constexpr float text_height = 15.0f;
constexpr float number_height = 13.0f;

// Latin, Greek, Cyrillic, and the symbols in labels and units.
const ImWchar* glyphs() {
    static constexpr std::array<ImWchar, 17> ranges{0x0020, 0x024F, 0x0370, 0x03FF, 0x0400, 0x04FF,
                                                    0x2010, 0x2044, 0x2070, 0x209F, 0x2190, 0x21FF,
                                                    0x2200, 0x22FF, 0x2300, 0x23FF, 0};
    return ranges.data();
}

// ImGui's built-in font is a 13-pixel bitmap. It is sharp only at whole multiples.
ImFont* add_built_in(ImFontAtlas& atlas, float scale) {
    ImFontConfig config;
    config.SizePixels = 13.0f * std::max(1.0f, std::round(scale));
    return atlas.AddFontDefault(&config);
}

ImFont* add(ImFontAtlas& atlas, const std::string& file, float height, float scale) {
    if (file.empty())
        return add_built_in(atlas, scale);
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    ImFont* font =
        atlas.AddFontFromFileTTF(file.c_str(), std::round(height * scale), &config, glyphs());
    return font ? font : add_built_in(atlas, scale);
}
}  // namespace

float fitted_scale(float wanted) {
    constexpr float steps = 8.0f;
    return std::clamp(std::round(wanted * steps) / steps, 0.5f, 4.0f);
}

BuiltFonts build_fonts(float scale) {
    const auto text = find_font_file({"Inter-Regular.otf", "Inter-Regular.ttf", "DejaVuSans.ttf"});
    const auto strong =
        find_font_file({"Inter-SemiBold.otf", "Inter-SemiBold.ttf", "DejaVuSans-Bold.ttf"});
    const auto numbers = find_font_file({"DejaVuSansMono.ttf", "Menlo.ttc"});
    auto atlas = std::make_unique<ImFontAtlas>();
    const Fonts fonts{.text = add(*atlas, text, text_height, scale),
                      .strong = add(*atlas, strong, text_height, scale),
                      .numbers = add(*atlas, numbers, number_height, scale)};
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    atlas->GetTexDataAsRGBA32(&pixels, &width, &height);  // the atlas keeps the pixels
    return {std::move(atlas), fonts, scale};
}

std::future<BuiltFonts> build_fonts_async(float scale) {
    return std::async(std::launch::async, build_fonts, scale);
}
