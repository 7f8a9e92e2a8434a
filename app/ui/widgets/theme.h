#pragma once

#include <imgui/imgui.h>

/// The colours of the window: neutral greys, always darker than the lights of a picture, and one
/// accent. Display-encoded.
namespace theme {
struct Color {
    float red, green, blue, alpha;
    operator ImVec4() const { return {red, green, blue, alpha}; }
};

constexpr Color none{0.0f, 0.0f, 0.0f, 0.0f};
constexpr Color surround{0.055f, 0.055f, 0.057f, 1.0f};  // around the picture
constexpr Color pane{0.098f, 0.098f, 0.102f, 1.0f};
constexpr Color popup{0.118f, 0.118f, 0.122f, 1.0f};
constexpr Color field{0.150f, 0.150f, 0.156f, 1.0f};
constexpr Color field_hovered{0.182f, 0.182f, 0.188f, 1.0f};
constexpr Color field_active{0.210f, 0.210f, 0.216f, 1.0f};
constexpr Color filled{0.262f, 0.262f, 0.270f, 1.0f};
constexpr Color line{0.165f, 0.165f, 0.170f, 1.0f};
constexpr Color text{0.790f, 0.790f, 0.780f, 1.0f};
constexpr Color label{0.640f, 0.640f, 0.635f, 1.0f};
constexpr Color dim{0.570f, 0.570f, 0.570f, 1.0f};
constexpr Color faint{0.440f, 0.440f, 0.445f, 1.0f};    // inactive text
constexpr Color outline{0.420f, 0.420f, 0.425f, 1.0f};  // of controls
constexpr Color accent{0.850f, 0.610f, 0.330f, 1.0f};
constexpr Color accent_filled{0.420f, 0.315f, 0.195f, 1.0f};
constexpr Color problem{0.900f, 0.430f, 0.380f, 1.0f};
constexpr Color problem_pane{0.160f, 0.085f, 0.080f, 0.940f};
// Of shader code.
constexpr Color code_keyword{0.620f, 0.700f, 0.900f, 1.0f};
constexpr Color code_type{0.500f, 0.760f, 0.720f, 1.0f};
constexpr Color code_call{0.830f, 0.800f, 0.600f, 1.0f};
constexpr Color code_number{0.860f, 0.680f, 0.480f, 1.0f};
constexpr Color code_directive{0.780f, 0.620f, 0.820f, 1.0f};
constexpr Color code_match{0.330f, 0.290f, 0.130f, 1.0f};  // behind a match of a search
constexpr Color warning{0.840f, 0.710f, 0.380f, 1.0f};

/// Opacity of the pane's colour over controls without an effect.
constexpr float dimming = 0.42f;

/// Colours and sizes of all widgets at scale 1.
ImGuiStyle style();
/// For draw lists.
inline ImU32 packed(const ImVec4& color) {
    return ImGui::ColorConvertFloat4ToU32(color);
}
}  // namespace theme
