#pragma once

#include <imgui/imgui.h>

#include <future>
#include <memory>

/// The faces of the window; their atlas owns them.
struct Fonts {
    ImFont* text = nullptr;
    ImFont* strong = nullptr;   // of a name or a heading
    ImFont* numbers = nullptr;  // digits of one width
};

/// An atlas of the fonts that the system has, best first, as pixels.
struct BuiltFonts {
    std::unique_ptr<ImFontAtlas> atlas;
    Fonts fonts;
    float scale = 0.0f;  // device pixels a pixel of the layout
};

/// The scale that fonts are built for, near a wanted one.
float fitted_scale(float wanted);
BuiltFonts build_fonts(float scale);
/// On a thread of its own; to be waited for before ImGui's context is made.
std::future<BuiltFonts> build_fonts_beside(float scale);
