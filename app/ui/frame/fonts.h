#pragma once

#include <imgui/imgui.h>

#include <future>
#include <memory>

/// The fonts of the window; the atlas owns them.
struct Fonts {
    ImFont* text = nullptr;
    ImFont* strong = nullptr;   // for names and headings
    ImFont* numbers = nullptr;  // monospaced digits
};

/// Pixel atlas of the best available system fonts.
struct BuiltFonts {
    std::unique_ptr<ImFontAtlas> atlas;
    Fonts fonts;
    float scale = 0.0f;  // device pixels per layout pixel
};

/// The wanted scale rounded to 1/8 and limited to 0.5 to 4.
float fitted_scale(float wanted);
BuiltFonts build_fonts(float scale);
/// On a background thread. Wait for the result before creating ImGui's context.
std::future<BuiltFonts> build_fonts_async(float scale);
