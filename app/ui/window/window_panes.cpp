#include "ui/window/window_panes.h"

#include "ui/actions/shortcuts.h"
#include "ui/dialogs/dialogs.h"
#include "ui/frame/action.h"
#include "ui/library/history_panel.h"
#include "ui/library/library_panel.h"
#include "ui/library/stack_panel.h"
#include "ui/parameters/parameters_panel.h"
#include "ui/parameters/sheet_panel.h"
#include "ui/parameters/step_view.h"
#include "ui/passes/inspector_panel.h"
#include "ui/passes/pass_strip.h"
#include "ui/picture/picture_panel.h"
#include "ui/playback/signal_panel.h"
#include "ui/playback/transport_bar.h"
#include "ui/status/bottom_panel.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/window/layout.h"
#include "ui/window/menu_bar.h"

#include <algorithm>

namespace {
// Transparent, so that the clear colour remains. On software GL, filling it again costs as much as
// drawing the panels.
constexpr theme::Color nothing{0.0f, 0.0f, 0.0f, 0.0f};

void draw_left(const Scene& scene, const Rect& place, Edits& edits) {
    Rect upper = place;
    Rect lower = place;
    // The list has its full height, up to 55 %.
    std::size_t lines = 2;
    for (const ListedLook& look : scene.library_view.looks())
        lines += 1 + (scene.lab.document() && look.entry.id == scene.lab.document()->look().id
                          ? look.presets.size() + 1
                          : 0);
    const float wanted = static_cast<float>(lines) * ImGui::GetTextLineHeightWithSpacing() +
                         2.0f * ImGui::GetStyle().WindowPadding.y;
    const float gap = 4.0f * scene.scale;
    upper.height = std::min(wanted, place.height * 0.55f);
    lower.top = upper.bottom() + gap;
    lower.height = place.bottom() - lower.top;
    {
        const Pane pane("library", upper, theme::pane);
        draw_library_panel(scene, edits);
    }
    const Pane pane("signal", lower, theme::pane);
    draw_stack_panel(scene, edits);
    draw_signal_panel(scene, edits);
}

void draw_middle(const Scene& scene, const Layout& layout, Edits& edits) {
    if (layout.transport.is_shown()) {
        const Pane pane("transport", layout.transport, theme::pane, true, false);
        draw_transport_bar(scene, edits);
    }
    {
        const Pane pane("picture", layout.picture, nothing, false);
        draw_picture_panel(scene, layout.picture, edits);
    }
    if (layout.strip.is_shown()) {
        const Pane pane("strip", layout.strip, theme::pane);
        draw_pass_strip(scene, edits);
    }
    if (layout.bottom.is_shown()) {
        const Pane pane("bottom", layout.bottom, theme::pane);
        draw_bottom_panel(scene, edits);
    }
}

void draw_panes(const Scene& scene, const Layout& layout, Edits& edits) {
    if (layout.library.is_shown() && scene.window.shows_history) {
        const Pane pane("history", layout.library, theme::pane, true, false);
        draw_history_panel(scene, edits);
    } else if (layout.library.is_shown()) {
        draw_left(scene, layout.library, edits);
    }
    draw_middle(scene, layout, edits);
    if (layout.parameters.is_shown()) {
        const Pane pane("parameters", layout.parameters, theme::pane);
        draw_parameters_panel(scene, edits);
    }
    if (layout.inspector.is_shown()) {
        const Pane pane("inspector", layout.inspector, theme::pane);
        draw_inspector_panel(scene, edits);
    }
    if (layout.status.is_shown()) {
        const Pane pane("status", layout.status, theme::pane, true, false);
        draw_status_bar(scene, edits);
    }
}
}  // namespace

void draw_window(const Scene& scene, Edits& edits) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSize(size);
    ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                             ImGuiWindowFlags_NoSavedSettings |
                             ImGuiWindowFlags_NoBringToFrontOnFocus |
                             ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBackground;
    if (!scene.window.is_picture_only)
        flags |= ImGuiWindowFlags_MenuBar;
    {
        const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::Begin("Afterglow", nullptr, flags);
    }
    if (!scene.window.is_picture_only)
        draw_menu_bar(scene, edits);
    const float top = scene.window.is_picture_only ? 0.0f : ImGui::GetFrameHeight();
    const Layout layout =
        arrange_panes(scene.window, {0.0f, top, size.x, size.y - top}, scene.scale);
    draw_panes(scene, layout, edits);
    draw_splitters(layout, scene.window, scene.scale, edits);
    ImGui::End();
    follow_pointer(scene, edits);
    leave_hidden_sheet(scene, edits);
    draw_dialogs(scene, edits);
    run_shortcuts(scene, edits);
}
