#pragma once

#include <imgui/imgui.h>

/// The faces of the window; owned by ImGui.
struct Fonts {
    ImFont* text = nullptr;
    ImFont* strong = nullptr;   // of a name or a heading
    ImFont* numbers = nullptr;  // digits of one width
};

/// Loads the fonts that the system has, best first, in place of those loaded before. `scale`:
/// device pixels a pixel of the layout.
Fonts load_fonts(float scale);
